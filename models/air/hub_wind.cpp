// The power law with the hub's height for that of reference.

#include "models/air/hub_wind.h"

#include <utility>

#include "models/air/wind_field.h"
#include "models/air/wind_kept.h"
#include "spoke/error.h"

namespace spoke::air {
namespace {

/// Returns the shear of the table of a description; none if it has no table, or one without.
std::optional<Curve> find_shear_course(const Wind& wind) {
  if (wind.by_program || wind.field || wind.file.empty()) return std::nullopt;
  return find_wind(wind)->shear_course();
}

}  // namespace

WindFault find_hub_wind_fault(const Wind& description, const Eigen::Vector3d& hub) {
  const bool has_shear = description.shear_exponent != 0.0 || description.vertical_shear != 0.0 ||
                         find_shear_course(description);
  const double height = WindAxes(description).height(hub);
  if (!has_shear || height > 0.0) return {};
  return {"ground", "is " + describe(description.ground) + ", and the hub is at a height of " +
                        describe(height) +
                        " over it, where shear leaves no wind that could be given; expected a "
                        "ground below the hub (m)"};
}

HubWind::HubWind(const Wind& description, std::shared_ptr<const WindField> replaced,
                 const Eigen::Vector3d& hub, const WindCourse& course)
    : replaced_(std::move(replaced)),
      course_(course),
      axes_(description),
      hub_(hub),
      hub_height_(axes_.height(hub)),
      shear_exponent_(description.shear_exponent),
      vertical_shear_(description.vertical_shear),
      horizontal_shear_(description.horizontal_shear),
      shear_course_(find_shear_course(description)) {
  if (const WindFault fault = find_hub_wind_fault(description, hub)) {
    const std::string key = "wind." + fault.key;
    throw InputError(key + ": " + fault.text, {.key = key});
  }
}

std::shared_ptr<const WindField> HubWind::with(const WindCourse& course) const {
  auto next = std::make_shared<HubWind>(*this);
  next->course_ = course;
  return next;
}

double HubWind::profile(const Eigen::Vector3d& place, double t) const {
  const double height = axes_.height(place);
  return calc_shear(height, hub_height_,
                    shear_course_ ? shear_course_->value(t) : shear_exponent_) +
         calc_linear_shear(height - hub_height_, (place - hub_).dot(axes_.across()), hub_height_,
                           vertical_shear_, horizontal_shear_);
}

}  // namespace spoke::air
