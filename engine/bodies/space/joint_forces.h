#pragma once

// Springs, dampers, stops and motors of joints.

#include "engine/bodies/space/joint_motion.h"

namespace spoke::space {

/// Shares of stiffness and damping in the unknown accelerations of an implicit step: beta' h^2 and
/// gamma' h of generalized_alpha. They are zero in an explicit evaluation.
struct ImplicitShares {
  double stiffness = 0.0;  ///< c [s^2]
  double damping = 0.0;    ///< c' [s]
};

/// The equation of a joint's coordinates, by coordinate: columns^T (wrench on the child) = tau -
/// share q''. Values beyond the n coordinates are zero.
struct JointForces {
  std::array<double, Joint::kMost> tau{};    ///< [N m, N]
  std::array<double, Joint::kMost> share{};  ///< c stiffness + c' damping [kg m^2, kg]
};

/// Sets the forces -k (q - rest) - d v + (stop) + motor, linearised about the accelerations `a`
/// that the coordinates have by now: tau = force + share a. Where an iteration has converged, the
/// forces are those of its coordinates exactly, also for stops and for a spherical spring, which
/// are not linear. `motor`: n forces [N m, N], or null; `a`: n accelerations, not used (and may be
/// null) if the shares are zero.
void calc_joint_forces(const Joint& joint, const JointState& state, const ImplicitShares& shares,
                       const double* a, const double* motor, JointForces& forces) noexcept;

/// Returns the potential energy of the springs and stops of a joint [J].
double calc_spring_energy(const Joint& joint, const JointState& state) noexcept;

/// Returns the power that the dampers of a joint and of its stops take [W].
double calc_dissipation(const Joint& joint, const JointState& state) noexcept;

}  // namespace spoke::space
