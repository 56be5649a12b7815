#pragma once

// Kinematics of a joint: from the handle on the parent that carries it to the child's frame. All
// that is carried along, primitive by primitive, is resolved in the parent's frame.

#include "models/space/joint.h"
#include "models/space/rotation_vector.h"

namespace spoke::space {

/// A motion given as a function of time, at one time [rad, m and per second].
struct PrescribedMotion {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

/// State of a joint. For a spherical primitive, q is the rotation vector by which it has turned
/// since the step's start, in the frame of its velocity w_J, which is v.
struct JointState {
  const double* q = nullptr;                 ///< n coordinates
  const double* v = nullptr;                 ///< n velocities
  const Quaternion* reference = nullptr;     ///< spherical primitive at the step's start
  const PrescribedMotion* driven = nullptr;  ///< motions by driven component
};

using JointColumns = Eigen::Matrix<double, kTwist, Joint::kMost, Eigen::DontAlign>;

/// The child's frame moves as
///   R (twist of the child) = T (twist of the handle) + columns (q', rates of driven ones)
///   R (X of the child) = T (acceleration of the handle) + columns q'' + bias
/// with T = [1, -p~; 0, 1], and the quantities of the handle in the parent's frame. If the child's
/// inboard handle moves against its frame (chords and mean axes), twist and X are those of that
/// handle, resolved in the child's frame.
struct JointMotion {
  Rotation R;  ///< from the child's frame to the parent's
  /// From the handle to the child's origin, of mean axes to its inboard handle, in the parent's
  /// frame [m].
  Position p;
  JointColumns columns;  ///< columns of the n coordinates, then of the driven components, then zero
  Twist bias;            ///< acceleration, where p ends, by rates and driven components
};

/// Sets the motion of a joint, and the child's twist (in the child's frame). `section` turns the
/// frame of the handle that carries the joint to the parent's frame, `handle` is the twist of that
/// handle in the parent's frame.
void calc_joint_motion(const Joint& joint, const JointState& state, const Rotation& section,
                       const Twist& handle, JointMotion& motion, Twist& child) noexcept;

/// Goes on to a child whose inboard section is turned against its frame by the motion `section`: so
/// far motion.R and `child` are those of the section, from here on those of the frame.
void leave_section(const RotationVectorMotion& section, JointMotion& motion, Twist& child) noexcept;

/// Returns X of the child (see JointMotion), in its frame, from the acceleration of the handle, in
/// the parent's, both less gravity, if the joint's coordinates have none:
/// R^T (T (acceleration) + bias).
Twist calc_carried_acceleration(const JointMotion& motion, const Twist& handle) noexcept;

/// Returns the orientation of a spherical primitive.
Quaternion calc_orientation(const Joint& joint, const JointPrimitive& spherical,
                            const JointState& state) noexcept;

/// Returns the force or moment of the drive of driven component `c`, from the wrench F on the
/// child's inboard handle in the child's frame [N, N m].
double calc_drive_force(const Joint& joint, const JointMotion& motion, int c,
                        const Twist& F) noexcept;

/// Returns the power of the drives of a joint, from that wrench [W].
double calc_drive_power(const Joint& joint, const JointState& state, const JointMotion& motion,
                        const Twist& F) noexcept;

}  // namespace spoke::space
