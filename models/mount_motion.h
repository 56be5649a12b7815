#pragma once

// Prescribed motion of a frame: translation and rotation vector as functions of time.

#include <Eigen/Core>
#include <array>
#include <variant>

#include "models/curve.h"

namespace spoke::spatial {

/// Three components x, y, z.
using Vector = Eigen::Vector3d;

/// A vector by a table of its components over time.
struct VectorTable {
  std::array<Curve, 3> components{};  ///< x, y, z [m, rad]
};

/// A vector constant + rate t + amplitude sin(frequency t + phase).
struct VectorHarmonic {
  Vector constant = Vector::Zero();   ///< [m, rad]
  Vector rate = Vector::Zero();       ///< [m/s, rad/s]
  Vector amplitude = Vector::Zero();  ///< [m, rad]
  double frequency = 0.0;             ///< [rad/s]
  double phase = 0.0;                 ///< [rad]
};

/// A vector that is a function of time.
using VectorCourse = std::variant<VectorTable, VectorHarmonic>;

/// The prescribed motion of a frame: of the axle's mount (a ship, a helicopter in manoeuvre, a
/// shake table) in the inertial frame, or of an anchor in the frame that it names.
struct MountMotion {
  VectorCourse translation{};  ///< translation of its origin; of a mount, of the hub's [m]
  VectorCourse rotation{};     ///< rotation vector [rad]
};

}  // namespace spoke::spatial
