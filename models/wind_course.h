#pragma once

// The velocity of the wind at a hub, as a program gives it step by step.

#include <Eigen/Core>

namespace spoke {

/// A velocity that goes from `velocity` to `target` at a constant rate, and stays there; inertial
/// frame. If it does not end after it begins, it is `target` at once.
struct WindCourse {
  double begin = 0.0;                                  ///< [s]
  double end = 0.0;                                    ///< [s]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< up to `begin` [m/s]
  Eigen::Vector3d target = Eigen::Vector3d::Zero();    ///< from `end` on [m/s]

  /// Returns the velocity at time t [s].
  Eigen::Vector3d at(double t) const {
    if (t >= end) return target;
    if (t <= begin) return velocity;
    return velocity + (t - begin) / (end - begin) * (target - velocity);
  }
};

}  // namespace spoke
