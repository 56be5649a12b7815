#pragma once

// Where a rotor is, how it moves, and the wind that it meets.

#include <Eigen/Core>

namespace spoke::air {

/// The rotor of a blade, inertial frame.
struct RotorPlace {
  Eigen::Vector3d center;    ///< of the hub [m]
  Eigen::Vector3d axis;      ///< unit vector about which it turns at positive speed
  Eigen::Vector3d velocity;  ///< of the hub's centre [m/s]
  double speed;              ///< about the axis [rad/s]
  Eigen::Vector3d wind;      ///< undisturbed, at the hub's centre [m/s]
};

}  // namespace spoke::air
