#pragma once

// Generalised forces of a subsystem at a state without accelerations: the forces on its coordinates
// and on the hub, including those of inertia at zero accelerations. For the accelerations a that
// the formulations find, F = M a (docs/modes.md).

#include <vector>

#include "engine/bodies/table/step_data.h"
#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// A wrench on a body in its frame, of what it carries besides the bodies of its subsystem.
template <class World>
struct CarriedWrench {
  int body = 0;
  TwistOf<World> wrench;
};

/// Sets the accelerations of all frames from the hub to the tips, for coordinates without
/// accelerations and the hub's as it is. Precondition: kinematics in the table are those of the
/// state.
template <class World>
void calc_frame_accelerations(const Subsystem<World>& subsystem, SubsystemData<World>& data);

/// Sums forces from the tips to the hub, those of loops by `response.multipliers` and of what the
/// bodies carry among them. Precondition: accelerations of frames and terms in the table are those
/// of the state, and so are the states of loops.
template <class World>
void calc_forces(const Subsystem<World>& subsystem,
                 const std::vector<CarriedWrench<World>>& carried, SubsystemData<World>& data,
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
