#pragma once

// Motion of a hub in space. Its coordinates are six: the place of its origin in the inertial frame,
// and the rotation vector by which it has turned since the step's start (see RotationBlock); for a
// hub on an axle (0, 0, angle) about the z axis of a reference frame that moves with the mount. Its
// velocities are those of the place, in the inertial frame, and the angular velocity w0, in the
// hub's frame H, less that of the mount about the axle.

#include "engine/bodies/space/rotation_block.h"
#include "models/space/quaternion.h"

namespace spoke::space {

/// Hub motion at the evaluated state.
struct HubState {
  Position p;   ///< place in the inertial frame [m]
  Rotation R;   ///< from H to the inertial frame
  Twist twist;  ///< velocity (resolved in H) and angular velocity
};

/// State of the hub's orientation besides its coordinates.
struct HubAttitude : RotationState {
  double mount_spin = 0.0;  ///< angular velocity of the mount about the axle [rad/s]
};

/// Orientation of the hub in a step's record: from H to the inertial frame.
struct RecordedHub : Rotation {
  double mount_spin = 0.0;  ///< see HubAttitude [rad/s]
};

/// Returns the state at six coordinates q = (p, D) and velocities v = (p', w): R = R_n exp(D~),
/// twist = (R^T p', w + mount_spin n), with n the axle and R_n the reference.
HubState calc_hub_state(const double* q, const double* v, const HubAttitude& attitude) noexcept;

}  // namespace spoke::space
