#pragma once

// Springs, dampers, stops, friction and motors of joints.

#include "engine/bodies/space/joint_motion.h"

namespace spoke::space {

/// Shares of stiffness and damping in the unknown accelerations of an implicit step: beta' h^2 and
/// gamma' h of generalized_alpha. They are zero in an explicit evaluation.
struct ImplicitShares {
  double stiffness = 0.0;  ///< c [s^2]
  double damping = 0.0;    ///< c' [s]
  /// The slope of friction is at least this share of its secant (its size by the velocity):
  /// tangents are exact near the solution, but may lead back and forth between sliding and
  /// sticking. It is 0 in the first passes of a step, and where velocities change by little.
  double secant = 0.0;
};

/// The equation of a joint's coordinates, by coordinate: columns^T (wrench on the child) = tau -
/// share q''. Values beyond the n coordinates are zero.
struct JointForces {
  std::array<double, Joint::kMost> tau{};    ///< [N m, N]
  std::array<double, Joint::kMost> share{};  ///< c stiffness + c' damping [kg m^2, kg]
};

/// What an actor adds to a coordinate of a joint.
struct JointEffort {
  double force = 0.0;        ///< [N m, N]
  double stiffness = 0.0;    ///< by which the force falls with the coordinate [N m/rad, N/m]
  double energy = 0.0;       ///< that it holds [J]
  double dissipation = 0.0;  ///< power that it takes [W]
};

/// Sets the forces -k (q - rest) - d v + (stop) + (friction) + motor, linearised about the
/// accelerations `a` that the coordinates have by now: tau = force + share a. Where an iteration
/// has converged, the forces are those of its coordinates exactly, also for stops, friction and a
/// spherical spring, which are not linear. `motor`: n forces [N m, N], or null; `a`: n
/// accelerations, not used (and may be null) if the shares are zero.
void calc_joint_forces(const Joint& joint, const JointState& state, const ImplicitShares& shares,
                       const double* a, const double* motor, JointForces& forces) noexcept;

/// Returns the potential energy of the springs and stops of a joint [J].
double calc_spring_energy(const Joint& joint, const JointState& state) noexcept;

/// Returns the power that the dampers of a joint and of its stops, and its friction take [W].
double calc_dissipation(const Joint& joint, const JointState& state) noexcept;

}  // namespace spoke::space
