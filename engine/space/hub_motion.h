#pragma once

// Motion of a hub in space. Its coordinates are six: the place of its origin in the inertial frame,
// and the rotation vector by which it has turned since the step's start (see RotationBlock), of a
// hub on an axle (0, 0, angle) about the z axis of a reference frame that moves with the mount. Its
// velocities are those of the place, in the inertial frame, and the angular velocity w0, in the
// hub's frame H, less that of the mount about the axle.

#include "engine/space/rotation_block.h"
#include "models/space/quaternion.h"

namespace spoke::space {

/// Hub motion at the evaluated state.
struct HubState {
  Position p;   ///< in the inertial frame [m]
  Rotation R;   ///< H to the inertial frame
  Twist twist;  ///< velocity (resolved in H) and angular velocity
};

/// What the hub's orientation has besides its coordinates.
struct HubAttitude : RotationState {
  double mount_spin = 0.0;  ///< angular velocity of the mount about the axle [rad/s]
};

/// What a step's record has of the hub's orientation: H to the inertial frame.
struct RecordedHub : Rotation {
  double mount_spin = 0.0;  ///< see HubAttitude [rad/s]
};

/// The state of six coordinates q and velocities v.
HubState calc_hub_state(const double* q, const double* v, const HubAttitude& attitude) noexcept;

}  // namespace spoke::space
