// What a simulation knows of its hub, bodies, markers and joints.

#include <utility>

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
  core_->model->require_place(marker);
  core_->evaluate();
  return core_->model->marker(marker, time());
}

Wrench Simulation::joint_reaction(int blade, int joint) const {
  core_->model->require_place({blade, joint, 0.0});
  core_->evaluate();
  return core_->model->joint_reaction(blade, joint);
}

Wrench Simulation::hub_reaction() const {
  core_->evaluate();
  return core_->model->hub_reaction();
}

Wrench Simulation::section_force(const Marker& marker) const {
  core_->model->require_place(marker);
  core_->evaluate();
  return core_->model->section_force(marker);
}

std::uint64_t Simulation::state_hash() const { return core_->model->hash(); }

}  // namespace spoke
