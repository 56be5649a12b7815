// Passes accelerations from the hub to the tips and forces back, by the joints of each world.

#include "engine/small_motions/steady/subsystem_forces.h"

#include <Eigen/Geometry>
#include <cassert>

#include "engine/bodies/kernels/dense_body.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/small_motions/steady/subsystem_access.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Bodies.

/// Returns the force on a body at zero accelerations of its deformation: [Q; Q_f] - [M_RR; C^T] X.
VectorXd calc_body_force(const BodyData<Plane>& body) {
  const plane::FlexibleBody& flexible = *body.model->body;
  const Position& S = body.terms.S;
  const Twist& X = body.X;
  VectorXd force(dense_size(flexible));
  calc_dense_force(body, force);
  force[0] -= flexible.mass * X[0] - S.y() * X[2];
  force[1] -= flexible.mass * X[1] + S.x() * X[2];
  force[2] -= S.x() * X[1] - S.y() * X[0] + body.terms.rotary_inertia * X[2];
  for (int k = 0; k < flexible.coordinates(); ++k) {
    const bool is_axial = k < flexible.axial();
    const double along =
        is_axial ? flexible.S_axial[k] * X[0] : flexible.S_bending[k - flexible.axial()] * X[1];
    force[kTwist + k] -= along + body.c_theta[body.layout.offset(k)] * X[2];
  }
  return force;
}
VectorXd calc_body_force(const BodyData<Space>& body) { return body.kind->calc_frame_force(body); }

/// Returns the Jacobian J of a handle; in the plane handle 0 is the inboard, 1 the outboard one.
template <class World>
MatrixXd calc_jacobian(const BodyData<World>& body, int handle) {
  MatrixXd J(World::kTwist, dense_size(*body.model->body));
  calc_handle_jacobian(body, handle, J);
  return J;
}

/// Returns the acceleration of a handle while the deformation has none.
Twist calc_handle_acceleration(const SubsystemData<Plane>& data, int j, int) {
  const BodyData<Plane>& body = data.bodies[static_cast<std::size_t>(j)];
  const Twist& twist = data.twists[static_cast<std::size_t>(j)];
  return calc_jacobian(body, 1).leftCols<kTwist>() * body.X + calc_handle_bias(body, 1, twist);
}
space::Twist calc_handle_acceleration(const SubsystemData<Space>& data, int j, int handle) {
  assert(handle >= 0 && handle < data.bodies[static_cast<std::size_t>(j)].work.port.handles);
  const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(j)];
  const space::HandleMotion& motion = body.work.handles[handle];
  const space::Angular w = angular(data.twists[static_cast<std::size_t>(j)]);
  space::Twist a = body.X + motion.bias(w);
  linear(a) += cross(angular(body.X), motion.s);
  return a;
}

// Joints.

/// Returns the acceleration X of a body that the hub or another body carries.
Twist carry(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data, std::size_t j) {
  if (j == 0)
    return calc_root_acceleration<Plane>(make_root_joint(subsystem, data), *data.hub_acceleration);
  return data.joints[j].R.inverse() * calc_handle_acceleration(data, static_cast<int>(j) - 1, 1);
}
space::Twist carry(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                   std::size_t j) {
  const TreeBody<Space>& model = subsystem.bodies[j];
  const space::Twist handle = model.parent < 0
                                  ? *data.hub_acceleration
                                  : calc_handle_acceleration(data, model.parent, model.handle);
  return calc_carried_acceleration(data.joints[j], handle) -
         data.bodies[j].work.handles[0].bias(angular(data.twists[j]));
}

/// Returns the wrench that the force on the frame of a body exerts on the handle that carries it.
Twist pass_inward(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                  std::size_t j, const Twist& force) {
  const Twist turned = data.joints[j].R * force;
  return j == 0 ? translate(subsystem.root.p, turned) : turned;
}
space::Twist pass_inward(const Subsystem<Space>&, const SubsystemData<Space>& data, std::size_t j,
                         const space::Twist& force) {
  return translate(data.joints[j].p, data.joints[j].R * force);
}

/// Sets the forces on the coordinates of the joint by that of its body.
void put_joint_force(const BodyData<Plane>&, const plane::JointMotion&, const Twist&, double*) {}
void put_joint_force(const BodyData<Space>& body, const space::JointMotion& motion,
                     const space::Twist& force, double* result) {
  const space::Twist turned = motion.R * force;
  for (int c = 0; c < body.model->joint.joint.coordinates; ++c)
    result[c] = motion.columns.col(c).dot(turned);
}

/// Adds the forces of the joint's springs and motors.
void add_joint_springs(const BodyData<Plane>&, double*) {}
void add_joint_springs(const BodyData<Space>& body, double* result) {
  for (int c = 0; c < body.model->joint.joint.coordinates; ++c)
    result[c] += body.joint.forces->tau[static_cast<std::size_t>(c)];
}

/// Returns the place of the first coordinate of each body in those of the subsystem, and their
/// number.
template <class World>
std::vector<Eigen::Index> find_starts(const Subsystem<World>& subsystem) {
  std::vector<Eigen::Index> starts{0};
  for (const TreeBody<World>& body : subsystem.bodies)
    starts.push_back(starts.back() + count_joint_coordinates(body) + body.body->coordinates());
  return starts;
}

/// Passes the forces on bodies inward. Sets those on coordinates, and returns that on the hub.
template <class World>
TwistOf<World> pass_all_inward(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                               const std::vector<Eigen::Index>& starts,
                               std::vector<VectorXd>& forces, VectorXd& on_coordinates) {
  constexpr Eigen::Index kHub = World::kTwist;
  on_coordinates.resize(starts.back());
  TwistOf<World> hub = TwistOf<World>::Zero();
  for (std::size_t j = data.bodies.size(); j-- > 0;) {
    const TreeBody<World>& model = subsystem.bodies[j];
    const BodyData<World>& body = data.bodies[j];
    const TwistOf<World> on_frame = forces[j].template head<kHub>();
    const Eigen::Index joint = count_joint_coordinates(model), nf = forces[j].size() - kHub;
    put_joint_force(body, data.joints[j], on_frame, on_coordinates.data() + starts[j]);
    // The deformation moves the frame against the inboard section.
    on_coordinates.segment(starts[j] + joint, nf) = forces[j].tail(nf);
    if (nf > 0)
      on_coordinates.segment(starts[j] + joint, nf) -=
          calc_jacobian(body, 0).rightCols(nf).transpose() * on_frame;
    const TwistOf<World> inward = pass_inward(subsystem, data, j, on_frame);
    if (model.parent < 0) {
      hub += inward;
      continue;
    }
    const auto parent = static_cast<std::size_t>(model.parent);
    forces[parent] += calc_jacobian(data.bodies[parent], model.handle).transpose() * inward;
  }
  return hub;
}

/// Adds the force `size` of a row of a loop to those on bodies. Returns that on the hub.
template <class World>
TwistOf<World> add_row_force(const LoopModel& loop, const LoopRowState<World>& row, double size,
                             const SubsystemData<World>& data, std::vector<VectorXd>& forces) {
  const auto add = [&](const LoopPlaceModel& place, const TwistOf<World>& unit) {
    const auto body = static_cast<std::size_t>(place.body);
    forces[body] += calc_jacobian(data.bodies[body], place.handle).transpose() * (size * unit);
  };
  add(loop.from, row.from);
  if (loop.to.carrier == LoopPlace::Carrier::body) add(loop.to, row.to);
  return size * row.hub;
}

/// Adds the efforts of a coupling, times its force, to those on coordinates.
void add_efforts(const LoopModel& loop, double size, const std::vector<Eigen::Index>& starts,
                 VectorXd& on_coordinates) {
  for (const CoupledCoordinate& at : loop.coupled)
    if (!at.is_driven)
      on_coordinates[starts[static_cast<std::size_t>(at.body)] + at.component] += size * at.ratio;
}

}  // namespace

template <class World>
void calc_frame_accelerations(const Subsystem<World>& subsystem, SubsystemData<World>& data) {
  for (std::size_t j = 0; j < data.bodies.size(); ++j) data.bodies[j].X = carry(subsystem, data, j);
}

template <class World>
void calc_forces(const Subsystem<World>& subsystem,
                 const std::vector<CarriedWrench<World>>& carried, SubsystemData<World>& data,
                 SubsystemResponse& response) {
  const std::vector<Eigen::Index> starts = find_starts(subsystem);
  std::vector<VectorXd> forces;
  for (const BodyData<World>& body : data.bodies) forces.push_back(calc_body_force(body));
  for (const CarriedWrench<World>& on : carried)
    forces[static_cast<std::size_t>(on.body)].template head<World::kTwist>() += on.wrench;
  TwistOf<World> of_rows = TwistOf<World>::Zero();
  std::size_t row = 0;
  for (const LoopModel& loop : subsystem.loops)
    for (std::size_t k = 0; k < loop.rows.size(); ++k, ++row)
      of_rows += add_row_force(loop, data.loops.states[row],
                               response.multipliers[static_cast<Eigen::Index>(row)], data, forces);
  TwistOf<World> hub = pass_all_inward(subsystem, data, starts, forces, response.force);
  row = 0;
  for (const LoopModel& loop : subsystem.loops) {
    add_efforts(loop, response.multipliers[static_cast<Eigen::Index>(row)], starts, response.force);
    row += loop.rows.size();
  }
  for (std::size_t j = 0; j < data.bodies.size(); ++j)
    add_joint_springs(data.bodies[j], response.force.data() + starts[j]);
  hub += of_rows;
  angular(hub) +=
      calc_stiffening_moment(sum_stiffening<World>(data.bodies), angular(data.hub->twist));
  response.hub_force = hub;
}

namespace {

template <class World>
MatrixXd pass_unit_forces(const Subsystem<World>& subsystem, const SubsystemData<World>& data) {
  const std::vector<Eigen::Index> starts = find_starts(subsystem);
  std::vector<VectorXd> none;
  for (const BodyData<World>& body : data.bodies)
    none.push_back(VectorXd::Zero(dense_size(*body.model->body)));
  MatrixXd closures(subsystem.loop_rows(), World::kTwist + starts.back());
  std::size_t row = 0;
  for (const LoopModel& loop : subsystem.loops)
    for (std::size_t k = 0; k < loop.rows.size(); ++k, ++row) {
      std::vector<VectorXd> forces = none;
      VectorXd on_coordinates;
      TwistOf<World> hub = add_row_force(loop, data.loops.states[row], 1.0, data, forces);
      hub += pass_all_inward(subsystem, data, starts, forces, on_coordinates);
      add_efforts(loop, 1.0, starts, on_coordinates);
      closures.row(static_cast<Eigen::Index>(row)) << hub.transpose(), on_coordinates.transpose();
    }
  return closures;
}

template <class World>
VectorXd sum_momenta(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                     const VectorXd& v) {
  const std::vector<Eigen::Index> starts = find_starts(subsystem);
  std::vector<VectorXd> momenta;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const Eigen::Index nf = data.bodies[j].model->body->coordinates();
    VectorXd rates(World::kTwist + nf);
    rates << data.twists[j], v.segment(starts[j + 1] - nf, nf);
    momenta.emplace_back(calc_body_mass(data.bodies[j]) * rates);
  }
  VectorXd on_coordinates;
  const TwistOf<World> hub = pass_all_inward(subsystem, data, starts, momenta, on_coordinates);
  VectorXd all(World::kTwist + on_coordinates.size());
  all << hub, on_coordinates;
  return all;
}

}  // namespace

VectorXd calc_momenta(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                      const VectorXd& v) {
  return sum_momenta(subsystem, data, v);
}
VectorXd calc_momenta(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                      const VectorXd& v) {
  return sum_momenta(subsystem, data, v);
}
MatrixXd calc_closures(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data) {
  return pass_unit_forces(subsystem, data);
}
MatrixXd calc_closures(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data) {
  return pass_unit_forces(subsystem, data);
}

template void calc_frame_accelerations(const Subsystem<Plane>&, SubsystemData<Plane>&);
template void calc_forces(const Subsystem<Plane>&, const std::vector<CarriedWrench<Plane>>&,
                          SubsystemData<Plane>&, SubsystemResponse&);
template void calc_frame_accelerations(const Subsystem<Space>&, SubsystemData<Space>&);
template void calc_forces(const Subsystem<Space>&, const std::vector<CarriedWrench<Space>>&,
                          SubsystemData<Space>&, SubsystemResponse&);

}  // namespace spoke::steady
