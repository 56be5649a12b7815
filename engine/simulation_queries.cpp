// What a simulation knows of its hub, bodies, markers and joints.

#include <utility>

#include "engine/body/section.h"
#include "engine/kernels/kinematics.h"
#include "engine/simulation.h"
#include "engine/simulation/simulation_core.h"
#include "engine/table/state_values.h"

namespace spoke {
namespace {

std::vector<double> unpadded(const double* flex, const FlexLayout& layout) {
  std::vector<double> values(flex + layout.u(), flex + layout.u() + layout.axial);
  values.insert(values.end(), flex + layout.v(), flex + layout.v() + layout.bending);
  return values;
}

Wrench wrench_in_space(const Twist& wrench) {
  return {{wrench[0], wrench[1], 0.0}, {0.0, 0.0, wrench[kRotation]}};
}

}  // namespace

HubMotion Simulation::hub() const {
  const CoordinateBlock& hub = core_->plane("the planar view of the hub").data.hub_coordinates;
  return {Twist(hub.q[0], hub.q[1], hub.q[2]), Twist(hub.v[0], hub.v[1], hub.v[2]),
          Twist(hub.a[0], hub.a[1], hub.a[2])};
}

BodyState Simulation::body(int blade, int body) const {
  const BodyData<Plane>& data = core_->find_body(blade, body);
  return {unpadded(data.coordinates.q, data.layout), unpadded(data.coordinates.v, data.layout),
          unpadded(data.coordinates.a, data.layout)};
}

void Simulation::calc_shape(int blade, BladeShape& shape) const {
  core_->find_body(blade, 0);
  SystemContext<Plane>& context = core_->plane("the shape of a blade");
  const auto index = static_cast<std::size_t>(blade);
  spoke::calc_shape(core_->scenario.rotor.blades[index], context.system.subsystems[index],
                    context.data.subsystems[index], shape);
}

void Simulation::calc_shape(int tree, TreeShape& shape) const {
  require_range("the index of the tree", tree, 0, core_->model->extent().subsystems - 1);
  core_->model->calc_shape(tree, time(), shape);
}

HubPose Simulation::hub_pose() const { return core_->model->hub_pose(); }

MarkerState Simulation::marker(const Marker& marker) const {
  const PlacedMarker<Plane> placed = core_->place(marker);
  core_->evaluate();
  const System<Plane>& system = core_->plane("markers").system;
  const auto blade = static_cast<std::size_t>(marker.blade);
  const Subsystem<Plane>& subsystem = system.subsystems[blade];
  const SubsystemData<Plane>& data = core_->plane("sections").data.subsystems[blade];
  MarkerState state{calc_marker_motion(subsystem, data, placed)};
  const Twist acceleration = calc_marker_acceleration(system.gravity_at(time()), data, placed);
  state.acceleration = in_space(Position(acceleration.head<kPosition>()));
  state.angular_acceleration.z() = acceleration[kRotation];
  const double x = (marker.body + marker.station) *
                   data.bodies[static_cast<std::size_t>(marker.body)].model->body->length;
  const Eigen::Vector3d in_hub =
      in_space(data.hub->R).transpose() * (state.position - in_space(data.hub->p));
  state.deflection = in_hub - in_space(subsystem.root.p + subsystem.root.R * Position{x, 0.0});
  state.foreshortening =
      in_space(calc_marker_foreshortening(subsystem, data, marker.body, marker.station));
  return state;
}

Wrench Simulation::joint_reaction(int blade, int joint) const {
  core_->place({blade, joint, 0.0});
  core_->evaluate();
  const SubsystemData<Plane>& data =
      core_->plane("joints").data.subsystems[static_cast<std::size_t>(blade)];
  const Twist& wrench = data.wrenches[static_cast<std::size_t>(joint)].inboard;
  return wrench_in_space(data.hub->R * calc_rotation_to_hub(data, joint) * wrench);
}

Wrench Simulation::hub_reaction() const {
  const StepData<Plane>& data = core_->plane("the planar view of the hub").data;
  core_->evaluate();
  Twist wrench = data.evaluated.reaction;
  wrench[kRotation] += data.evaluated.applied_torque;
  return wrench_in_space(data.subsystems.front().hub->R * wrench);
}

Wrench Simulation::section_force(const Marker& marker) const {
  const PlacedMarker<Plane> placed = core_->place(marker);
  core_->evaluate();
  const auto blade = static_cast<std::size_t>(marker.blade);
  return wrench_in_space(calc_section_force(
      core_->scenario.rotor.blades[blade], core_->plane("sections").system.damping,
      core_->plane("sections").data.subsystems[blade].bodies[static_cast<std::size_t>(marker.body)],
      placed.section));
}

std::uint64_t Simulation::state_hash() const { return core_->model->hash(); }

}  // namespace spoke
