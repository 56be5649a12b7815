#pragma once

// Motion of a hub in space. Its coordinates are six: the place of its origin in the inertial frame,
// and the rotation vector by which it has turned since the step's start (see RotationBlock), of a
// hub on an axle (0, 0, angle) about the z axis of a reference frame that stays. Its velocities are
// those of the place, in the inertial frame, and the angular velocity w0, in the hub's frame H.

#include <array>

#include "models/space/quaternion.h"

namespace spoke::space {

/// Which components of the hub's twist are prescribed: x, y, z, rx, ry, rz. Of the translation all,
/// or none.
using Prescribed = std::array<bool, kTwist>;

/// Hub motion at the evaluated state.
struct HubState {
  Position p;   ///< in the inertial frame [m]
  Rotation R;   ///< H to the inertial frame
  Twist twist;  ///< velocity (resolved in H) and angular velocity
};

/// The state of six coordinates q and velocities v; `reference`: the orientation at no rotation.
HubState calc_hub_state(const double* q, const double* v, const Quaternion& reference) noexcept;

/// Y'' = (R^T (r'' - g), w0') of prescribed components, in H; of the others zero. `acceleration`:
/// r'' of the origin, inertial frame; `alpha`: w0', in H; of a hub on a fixed axle zero, and (0, 0,
/// the drive's).
Twist calc_given(const Prescribed& prescribed, const Rotation& R, const Position& gravity,
                 const Position& acceleration, const Angular& alpha) noexcept;

/// Accelerations of the free coordinates, (r'', w0'), from Y''; of prescribed ones zero.
Twist calc_coordinate_accelerations(const Prescribed& prescribed, const Rotation& R,
                                    const Position& gravity, const Twist& acceleration) noexcept;

}  // namespace spoke::space
