#pragma once

// The prescribed motion of the mount that holds the hub's axle.

#include "models/space/hub.h"

namespace spoke::space {

/// Motion of the frame A in which the axle turns, as seen from the inertial frame: A is H at the
/// angle 0.
struct AxleMotion {
  Position p = Position::Zero();    ///< position of its origin, inertial frame [m]
  Position v = Position::Zero();    ///< velocity of its origin, inertial frame [m/s]
  Position a = Position::Zero();    ///< acceleration of its origin, inertial frame [m/s^2]
  Rotation R;                       ///< rotation from A to the inertial frame
  Angular w = Angular::Zero();      ///< angular velocity, in A [rad/s]
  Angular alpha = Angular::Zero();  ///< angular acceleration, in A [rad/s^2]
};

/// Returns the motion at time t [s]. With the mount's rotation vector theta, R = exp(theta~) R_A at
/// theta = 0, and the angular velocity is H theta', the angular acceleration H theta'' + H' theta',
/// both in the inertial frame. At rest if there is no mount.
AxleMotion calc_axle_motion(const Hub& hub, double t) noexcept;

}  // namespace spoke::space
