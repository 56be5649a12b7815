#pragma once

// Motion of a hub in space. Its coordinates are six: the place of its origin in the inertial frame,
// and the rotation vector by which it has turned since the step's start (see RotationBlock), of a
// hub on an axle (0, 0, angle) about the z axis of a reference frame that stays. Its velocities are
// those of the place, in the inertial frame, and the angular velocity w0, in the hub's frame H.

#include "models/space/quaternion.h"

namespace spoke::space {

/// Hub motion at the evaluated state.
struct HubState {
  Position p;   ///< in the inertial frame [m]
  Rotation R;   ///< H to the inertial frame
  Twist twist;  ///< velocity (resolved in H) and angular velocity
};

/// The state of six coordinates q and velocities v; `reference`: the orientation at no rotation.
HubState calc_hub_state(const double* q, const double* v, const Quaternion& reference) noexcept;

}  // namespace spoke::space
