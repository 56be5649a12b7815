#pragma once

// A rigid body in space, as constant data.

#include <vector>

#include "models/space/space.h"

namespace spoke::space {

/// A rigid body in its frame, whose origin is its inboard handle. The inertia must be positive
/// definite: a point mass, or a rod that does not resist spin, is no body, but an addition to one.
struct RigidBody {
  double mass = 0.0;                   ///< [kg]
  Position centre = Position::Zero();  ///< centre of mass [m]
  Matrix3 inertia = Matrix3::Zero();   ///< inertia about the centre of mass [kg m^2]
  /// Handles at which children hang, then those of loops [m].
  std::vector<Position> outboard{};
  /// Angular momentum of what spins inside, relative to the body, which stays [kg m^2/s].
  Position spin = Position::Zero();
  /// Whether it is the hub of a rotor on a support: alone it may have no mass.
  bool is_hub = false;
};

/// M_RR = [m 1, -S~; S~, Theta], S = m c, Theta about the frame's origin.
SymmetricTwistMatrix calc_mass(const RigidBody& body);

}  // namespace spoke::space
