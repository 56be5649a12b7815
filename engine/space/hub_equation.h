#pragma once

// The hub in space, in its own frame H: the equation of motion (P 9) in the unknowns
// Y'' = (R_0^T (r'' - g), w0'), whose components are prescribed or free one by one. The frame of a
// hub on an axle has its z axis along it: x, y, z, rx, ry are prescribed by the axle, rz by the
// drive.

#include <span>

#include "engine/space/body_data.h"
#include "engine/space/hub_motion.h"
#include "engine/tree/joint_elimination.h"
#include "models/space/space.h"

namespace spoke::space {

/// The hub with all that hangs on it: mass Y'' = force + reaction.
struct HubEquation {
  TwistMatrix mass;
  Twist force;
};

/// Sums the equation, in the order of the subsystems. `mass`: of the hub alone, about its origin;
/// `twist`: of the hub; `applied`: the wrench of motor and loads; all in H.
HubEquation sum_hub_equation(const SymmetricTwistMatrix& mass, const Twist& twist,
                             const Twist& applied, const HubStiffening& stiffening,
                             std::span<const tree::HubShare<Space>> subsystems) noexcept;

/// What solving the hub's equation yields.
struct HubAcceleration {
  Twist acceleration;  ///< Y'', less gravity
  Twist reaction;      ///< of support and drive on the hub, in prescribed components
  /// Least pivot of a free component by its diagonal entry, 1 if none is free. If it is not
  /// positive, stiffening has taken the mass its definiteness, and no acceleration is to be
  /// trusted.
  double least_pivot;
};

/// Solves for the free components; `given` holds the others, of Y''.
HubAcceleration solve_hub(const HubEquation& equation, const Prescribed& prescribed,
                          const Twist& given) noexcept;

}  // namespace spoke::space
