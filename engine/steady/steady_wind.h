#pragma once

// Wind as steady rotation knows it: the same at every place and time, and where the hub turns along
// its axis.

#include <Eigen/Core>

#include "models/wind.h"

namespace spoke::steady {

class SteadyWind final : public WindField {
 public:
  explicit SteadyWind(const Eigen::Vector3d& velocity) : full_(velocity), velocity_(velocity) {}

  Eigen::Vector3d velocity(const Eigen::Vector3d&, double) const override { return velocity_; }
  /// Keeps of the wind its part along an axis, a unit vector.
  void keep_axial(const Eigen::Vector3d& axis) { velocity_ = full_ = axis * axis.dot(full_); }
  /// Lets the wind's speed be this share of its own.
  void set_share(double share) { velocity_ = share * full_; }

 private:
  Eigen::Vector3d full_, velocity_;
};

}  // namespace spoke::steady
