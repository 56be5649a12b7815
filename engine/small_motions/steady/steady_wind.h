#pragma once

// Wind as steady rotation knows it: the same at every time. Unless it counts in full, it is the
// same at every place, too, and where the hub turns along its axis.

#include <Eigen/Core>
#include <memory>
#include <utility>

#include "models/wind.h"

namespace spoke::steady {

class SteadyWind final : public WindField {
 public:
  /// Takes the wind at t = 0; at all places that at the origin, unless it is one of places.
  SteadyWind(std::shared_ptr<const WindField> wind, bool is_of_places)
      : full_(wind->velocity(Eigen::Vector3d::Zero(), 0.0)), velocity_(full_) {
    if (is_of_places) by_place_ = std::move(wind);
  }

  Eigen::Vector3d velocity(const Eigen::Vector3d& place, double) const override {
    return by_place_ ? Eigen::Vector3d(share_ * by_place_->velocity(place, 0.0)) : velocity_;
  }
  /// Keeps of the wind its part along an axis, a unit vector, at all places that at the origin.
  void keep_axial(const Eigen::Vector3d& axis) {
    velocity_ = full_ = axis * axis.dot(full_);
    by_place_.reset();
  }
  /// Lets the wind's speed be this share of its own.
  void set_share(double share) {
    share_ = share;
    velocity_ = share * full_;
  }

 private:
  std::shared_ptr<const WindField> by_place_;
  double share_ = 1.0;
  Eigen::Vector3d full_, velocity_;
};

}  // namespace spoke::steady
