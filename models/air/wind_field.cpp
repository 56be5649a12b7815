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

/// Returns what a gust adds to what it changes at time t.
double calc_gust(const WindGust& gust, double t) {
  const double share = (t - gust.start) / gust.duration;
  if (gust.shape == GustShape::rise)
    return 0.5 * gust.amplitude *
           (1.0 - std::cos(std::numbers::pi * std::fmin(std::fmax(share, 0.0), 1.0)));
  if (!(share > 0.0 && share < 1.0)) return 0.0;
  const double rise = 1.0 - std::cos(2.0 * std::numbers::pi * share);
  if (gust.shape == GustShape::one_minus_cosine) return 0.5 * gust.amplitude * rise;
  return -0.37 * gust.amplitude * std::sin(3.0 * std::numbers::pi * share) * rise;
}

/// What gusts change at one time, and the shear that stays.
struct WindChanges {
  double speed = 0.0, direction = 0.0;
  double vertical_shear, horizontal_shear;

  explicit WindChanges(const Wind& wind)
      : vertical_shear(wind.vertical_shear), horizontal_shear(wind.horizontal_shear) {}
  void add(const WindGust& gust, double t) {
    const double change = calc_gust(gust, t);
    switch (gust.of) {
      case GustOf::speed:
        speed += change;
        break;
      case GustOf::direction:
        direction += change;
        break;
      case GustOf::vertical_shear:
        vertical_shear += change;
        break;
      case GustOf::horizontal_shear:
        horizontal_shear += change;
        break;
    }
  }
};

class DescribedWind final : public WindField {
 public:
  DescribedWind(const Wind& wind, WindData data)
      : axes_(wind),
        speed_(wind.velocity.norm()),
        course_(wind.speed),
        shear_exponent_(wind.shear_exponent),
        reference_height_(wind.reference_height.value_or(0.0)),
        gusts_(wind.gusts),
        steady_(wind),
        table_(std::move(data.table)),
        box_(std::move(data.box)) {
    if (box_ && !wind.turbulence) average_ = box_->average();
  }

  Vector3d velocity(const Vector3d& place, double t) const override {
    WindChanges now = steady_;
    for (const WindGust& gust : gusts_) now.add(gust, t);
    Vector3d velocity = average_ ? Vector3d(box_->speed * calc_linear(place, now) * axes_.along())
                                 : mean_at(place, t, now);
    if (now.speed != 0.0) velocity += now.speed * axes_.along();
    if (box_) velocity += in_box(*box_, place, t);
    if (now.direction == 0.0) return velocity;
    return Eigen::AngleAxisd(now.direction, axes_.up()) * velocity;
  }

  Vector3d mean(const Vector3d& place) const override {
    if (average_) return in_box(*average_, place, 0.0);
    if (!table_) return mean_at(place, 0.0, steady_);
    const std::vector<double>& times = table_->speed.times();
    constexpr int kSamples = 1000;
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < kSamples; ++k)
      sum += mean_at(place, times.front() + (times.back() - times.front()) * (k + 0.5) / kSamples,
                     steady_);
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

  /// Returns what linear shear adds at a place, over the speed at the reference height.
  double calc_linear(const Vector3d& place, const WindChanges& now) const {
    return calc_linear_shear(axes_.height(place) - reference_height_, place.dot(axes_.across()),
                             reference_height_, now.vertical_shear, now.horizontal_shear);
  }

  Vector3d mean_at(const Vector3d& place, double t, const WindChanges& now) const {
    const double exponent =
        table_ && table_->shear_exponent ? table_->shear_exponent->value(t) : shear_exponent_;
    const double profile =
        calc_shear(axes_.height(place), reference_height_, exponent) + calc_linear(place, now);
    if (!table_) return (course_ ? course_->value(t) : speed_) * profile * axes_.along();
    const double direction = table_->direction.value(t);
    return table_->speed.value(t) * profile *
               (std::cos(direction) * axes_.along() + std::sin(direction) * axes_.across()) +
           table_->vertical_speed.value(t) * axes_.up();
  }

  WindAxes axes_;
  double speed_;
  std::optional<Curve> course_;
  double shear_exponent_, reference_height_;
  std::vector<WindGust> gusts_;
  WindChanges steady_;
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

double calc_linear_shear(double upwards, double across, double reference_height, double vertical,
                         double horizontal) noexcept {
  if (vertical == 0.0 && horizontal == 0.0) return 0.0;
  return vertical * std::fmax(upwards, -reference_height) + horizontal * across;
}

std::shared_ptr<const WindField> compose_wind(const Wind& wind, WindData data) {
  return std::make_shared<DescribedWind>(wind, std::move(data));
}

}  // namespace spoke::air
