#pragma once

// Generalised forces of a subsystem at a state without accelerations: the forces on its coordinates
// and on the hub, including those of inertia at zero accelerations. For the accelerations a that
// the formulations find, F = M a (docs/modes.md).

#include "engine/bodies/table/step_data.h"
#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Sets the accelerations of all frames from the hub to the tips, for coordinates without
/// accelerations and the hub's as it is; then sums forces from the tips to the hub, those of loops
/// by `response.multipliers` among them. Precondition: kinematics and terms in the table are those
/// of the state, and so are the states of loops.
void calc_forces(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data,
                 SubsystemResponse& response);
void calc_forces(const Subsystem<Space>& subsystem, SubsystemData<Space>& data,
                 SubsystemResponse& response);

/// Returns the momenta that belong to the hub's twist and, below, to the coordinates, by the twists
/// of frames in the table and the velocities `v` of the coordinates: a product with the mass
/// matrix.
Eigen::VectorXd calc_momenta(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                             const Eigen::VectorXd& v);
Eigen::VectorXd calc_momenta(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                             const Eigen::VectorXd& v);

/// Returns what unit forces of the rows of loops are on hub and coordinates, see
/// SteadyModel::closures().
Eigen::MatrixXd calc_closures(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data);
Eigen::MatrixXd calc_closures(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data);

}  // namespace spoke::steady
