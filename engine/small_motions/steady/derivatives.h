#pragma once

// Derivatives of the forces on a subsystem and the hub at a state. Elastic forces are held: they
// are linear, and their constant matrices are known exactly. So are the forces of springs in
// closures, if the state says so: they turn with their loops. The remaining forces are smooth on
// the scale of the coordinates, so that differences lose no digits to the stiffest vibrations.

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Calculates dF/dq with elastic forces and the forces of loops held, by second-order differences,
/// for Newton's method. Leaves the state evaluated.
Eigen::MatrixXd calc_rough_derivative(std::size_t subsystem, const SubsystemState& state,
                                      SteadyModel& model);

/// Returns the stiffness of the springs in closures: Phi^T k Phi with the rows `closures` of
/// SteadyModel::closures(), on hub and coordinates.
Eigen::MatrixXd calc_spring_stiffness(const std::vector<ClosureRow>& rows,
                                      const Eigen::MatrixXd& closures);

/// Returns the stiffness matrix of a subsystem at rest for Newton's method, where the rows of its
/// loops have these forces. Leaves the state evaluated.
Eigen::MatrixXd calc_stiffness(std::size_t subsystem, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& multipliers, SteadyModel& model);

/// Derivatives of the forces on the subsystem's n coordinates and, below, on the hub, by
/// coordinates, velocities, the hub's turn and the hub's twist.
struct SubsystemDerivatives {
  Eigen::MatrixXd by_q, by_v, by_turn, by_twist;
};

/// Calculates these by central differences with steps by the scale of each coordinate: of fourth
/// order for coordinates and the hub's turn (Richardson's extrapolation of two steps); of second
/// order for velocities, in which forces are quadratic, so that these differences are exact.
/// Derivatives by the hub's motion are empty unless `with_hub`. Leaves the state evaluated.
SubsystemDerivatives calc_derivatives(std::size_t subsystem, const SubsystemState& state,
                                      bool with_hub, SteadyModel& model);

/// Returns the derivatives of the same forces by z of `forces`, in columns, which held states have.
Eigen::MatrixXd calc_by_forces(std::size_t subsystem, const SubsystemState& state,
                               const std::vector<ForceState>& forces, SteadyModel& model);

}  // namespace spoke::steady
