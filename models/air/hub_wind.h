#pragma once

// The wind of a program that gives its velocity at the hub.

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "models/air/wind_field.h"
#include "models/air/wind_rules.h"
#include "models/curve.h"
#include "models/wind.h"
#include "models/wind_course.h"

namespace spoke::air {

/// A wind of which the velocity at the hub is given, instead of what a description says of speed,
/// direction, gusts and turbulence. The description's shear is kept, that of its table included:
/// v(p, t) = v(hub, t) ((h/h_hub)^a + k_v (h - h_hub) + k_h y) with h the height of p over the
/// ground, and y its distance from the hub across the wind of the description.
class HubWind final : public WindField {
 public:
  /// replaced: the wind of the description; hub: its place, which stays [m]. Throws InputError if
  /// the description has shear, and the hub is not above the ground.
  HubWind(const Wind& description, std::shared_ptr<const WindField> replaced,
          const Eigen::Vector3d& hub, const WindCourse& course);

  Eigen::Vector3d velocity(const Eigen::Vector3d& place, double t) const override {
    return course_.at(t) * profile(place, t);
  }
  double memory() const override { return replaced_ ? replaced_->memory() : 0.0; }
  /// Returns a wind with another course at the same hub.
  std::shared_ptr<const WindField> with(const WindCourse& course) const;
  const std::shared_ptr<const WindField>& replaced() const { return replaced_; }
  const WindCourse& course() const { return course_; }

 private:
  double profile(const Eigen::Vector3d& place, double t) const;

  std::shared_ptr<const WindField> replaced_;
  WindCourse course_;
  WindAxes axes_;
  Eigen::Vector3d hub_;
  double hub_height_;
  double shear_exponent_, vertical_shear_, horizontal_shear_;
  std::optional<Curve> shear_course_;  ///< in place of shear_exponent_
};

/// Returns why no velocity at the hub can be given in place of the wind of a description; empty if
/// one can. hub: its place [m].
WindFault find_hub_wind_fault(const Wind& description, const Eigen::Vector3d& hub);

}  // namespace spoke::air
