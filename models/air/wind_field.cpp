// Adds mean wind, gust and turbulence at a place and a time.

#include "models/air/wind_field.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "models/air/wind_rules.h"

namespace spoke::air {
namespace {

using Eigen::Vector3d;

/// Returns what a gust adds to the speed at time t.
double calc_gust(const WindGust& gust, double t) {
  const double share = (t - gust.start) / gust.duration;
  if (!(share > 0.0 && share < 1.0)) return 0.0;
  const double rise = 1.0 - std::cos(2.0 * std::numbers::pi * share);
  if (gust.shape == GustShape::one_minus_cosine) return 0.5 * gust.amplitude * rise;
  return -0.37 * gust.amplitude * std::sin(3.0 * std::numbers::pi * share) * rise;
}

class DescribedWind final : public WindField {
 public:
  DescribedWind(const Wind& wind, WindData data)
      : axes_(wind),
        speed_(wind.velocity.norm()),
        course_(wind.speed),
        shear_exponent_(wind.shear_exponent),
        reference_height_(wind.reference_height.value_or(0.0)),
        gust_(wind.gust),
        table_(std::move(data.table)),
        box_(std::move(data.box)) {
    if (box_ && !wind.turbulence) average_ = box_->average();
  }

  Vector3d velocity(const Vector3d& place, double t) const override {
    Vector3d velocity = average_ ? Vector3d(Vector3d::Zero()) : mean_at(place, t);
    if (gust_) velocity += calc_gust(*gust_, t) * axes_.along();
    return box_ ? Vector3d(velocity + in_box(*box_, place, t)) : velocity;
  }

  Vector3d mean(const Vector3d& place) const override {
    if (average_) return in_box(*average_, place, 0.0);
    if (!table_) return mean_at(place, 0.0);
    const std::vector<double>& times = table_->speed.times();
    constexpr int kSamples = 1000;
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < kSamples; ++k)
      sum += mean_at(place, times.front() + (times.back() - times.front()) * (k + 0.5) / kSamples);
    return sum / kSamples;
  }

  double end() const override { return box_ ? box_->end() : WindField::end(); }
  double memory() const override {
    const std::size_t values = box_ ? box_->values.size() : 0;
    return static_cast<double>(values * sizeof(float));
  }

 private:
  Vector3d in_box(const WindBox& box, const Vector3d& place, double t) const {
    return axes_.velocity(
        box.velocity(place.dot(axes_.along()), place.dot(axes_.across()), axes_.height(place), t));
  }

  Vector3d mean_at(const Vector3d& place, double t) const {
    const double height = axes_.height(place);
    if (!table_)
      return (course_ ? course_->value(t) : speed_) *
             calc_shear(height, reference_height_, shear_exponent_) * axes_.along();
    const double exponent =
        table_->shear_exponent ? table_->shear_exponent->value(t) : shear_exponent_;
    const double direction = table_->direction.value(t);
    return table_->speed.value(t) * calc_shear(height, reference_height_, exponent) *
               (std::cos(direction) * axes_.along() + std::sin(direction) * axes_.across()) +
           table_->vertical_speed.value(t) * axes_.up();
  }

  WindAxes axes_;
  double speed_;
  std::optional<Curve> course_;
  double shear_exponent_, reference_height_;
  std::optional<WindGust> gust_;
  std::optional<WindTable> table_;
  std::shared_ptr<const WindBox> box_;
  /// Of a file of TurbSim, whose box is the whole wind; none: the mean wind is described.
  std::optional<WindBox> average_;
};

}  // namespace

WindAxes::WindAxes(const Wind& wind)
    : along_(direction_of(wind)), up_(wind.up.normalized()), ground_(wind.ground) {
  // Along up there is nothing across, and nothing that asks for it.
  const Vector3d across = up_.cross(along_);
  if (across.norm() > 0.0) across_ = across.normalized();
  upward_ = along_.cross(across_);
}

double calc_shear(double height, double reference_height, double exponent) noexcept {
  if (exponent == 0.0) return 1.0;
  return height > 0.0 ? std::pow(height / reference_height, exponent) : 0.0;
}

std::shared_ptr<const WindField> compose_wind(const Wind& wind, WindData data) {
  return std::make_shared<DescribedWind>(wind, std::move(data));
}

}  // namespace spoke::air
