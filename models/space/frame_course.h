#pragma once

// The prescribed motion of a frame against the one in which it is given, from its translation and
// rotation vector.

#include "models/mount_motion.h"
#include "models/space/space.h"

namespace spoke::space {

/// A motion of a frame B in a frame A, all resolved in A.
struct FrameCourse {
  Position p = Position::Zero();    ///< place of its origin [m]
  Position v = Position::Zero();    ///< [m/s]
  Position a = Position::Zero();    ///< [m/s^2]
  Rotation R;                       ///< from B to A
  Angular w = Angular::Zero();      ///< angular velocity [rad/s]
  Angular alpha = Angular::Zero();  ///< angular acceleration [rad/s^2]
};

/// A vector with its derivatives.
struct VectorMotion {
  Position value = Position::Zero(), rate = Position::Zero(), acceleration = Position::Zero();
};

/// Returns a vector and its derivatives at time t [s].
VectorMotion follow(const spatial::VectorCourse& course, double t);

/// Returns the motion of a frame by its translation and its rotation vector theta: R = exp(theta~),
/// w = H theta', alpha = H theta'' + H' theta'.
FrameCourse make_frame_course(const VectorMotion& translation, const VectorMotion& rotation);

}  // namespace spoke::space
