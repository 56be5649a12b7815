// Answers queries about hub, bodies, markers and joints of a simulation.

#include <iterator>
#include <optional>
#include <utility>

#include "engine/bodies/table/state_values.h"
#include "engine/simulation.h"
#include "engine/simulation/require_range.h"
#include "engine/simulation/simulation_core.h"

namespace spoke {
namespace {

template <class World>
const BodyData<World>& find_body(const SystemContext<World>& context, int subsystem, int body) {
  const auto& subsystems = context.data.subsystems;
  require_range("the index of the blade", subsystem, 0,
                static_cast<std::int64_t>(subsystems.size()) - 1);
  const auto& bodies = subsystems[static_cast<std::size_t>(subsystem)].bodies;
  require_range("the index of the body", body, 0, static_cast<std::int64_t>(bodies.size()) - 1);
  return bodies[static_cast<std::size_t>(body)];
}

template <class World>
BodyState make_view(const BodyData<World>& body) {
  const auto values = [&body](const double* flex) {
    std::vector<double> unpadded;
    body.layout.for_parts(
        [&](int first, int n) { unpadded.insert(unpadded.end(), flex + first, flex + first + n); });
    return unpadded;
  };
  return {values(body.coordinates.q), values(body.coordinates.v), values(body.coordinates.a)};
}

}  // namespace

HubMotion Simulation::hub() const {
  const CoordinateBlock& hub = core_->plane("the planar view of the hub").data.hub_coordinates;
  return {Twist(hub.q[0], hub.q[1], hub.q[2]), Twist(hub.v[0], hub.v[1], hub.v[2]),
          Twist(hub.a[0], hub.a[1], hub.a[2])};
}

HubFrame Simulation::hub_frame() const {
  const MarkerState frame = core_->model->hub_frame(time());
  return {hub_pose(), frame.velocity, frame.angular_velocity, frame.acceleration,
          frame.angular_acceleration};
}

LoopsAtStart Simulation::loops_at_start() const { return core_->model->loops_at_start(); }

MarkerMotion Simulation::anchor_frame(int anchor) const {
  const std::optional<spatial::Model>& space = core_->scenario.space;
  const auto anchors =
      space ? std::ssize(space->anchors) : std::ssize(core_->scenario.rotor.anchors);
  require_range("the index of the anchor", anchor, 0, anchors - 1);
  return core_->model->carrier_frame(anchor, time());
}

MarkerMotion Simulation::mount_frame() const { return core_->model->carrier_frame(-1, time()); }

BodyState Simulation::body(int blade, int body) const {
  if (const SystemContext<Space>* space = core_->model->space())
    return make_view(find_body(*space, blade, body));
  return make_view(find_body(core_->plane("the view of a body"), blade, body));
}

void Simulation::calc_shape(int blade, BladeShape& shape) const {
  SystemContext<Plane>& context = core_->plane("the shape of a blade");
  find_body(context, blade, 0);
  const auto index = static_cast<std::size_t>(blade);
  spoke::calc_shape(core_->scenario.rotor.blades[index], context.system.subsystems[index],
                    context.data.subsystems[index], shape);
}

void Simulation::calc_shape(int tree, TreeShape& shape) const {
  require_range("the index of the tree", tree, 0, core_->model->extent().subsystems - 1);
  core_->model->calc_shape(tree, time(), shape);
}

HubPose Simulation::hub_pose() const { return core_->model->hub_pose(); }
MarkerMotion Simulation::base_frame() const { return core_->model->base_frame(time()); }

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

Wrench Simulation::loop_reaction(int tree, std::string_view loop) const {
  core_->model->require_loop(tree, loop);
  core_->evaluate();
  return core_->model->loop_reaction(tree, loop, time());
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

std::vector<EventInRun> Simulation::events() const {
  return core_->events ? core_->events->in_run() : std::vector<EventInRun>{};
}

std::uint64_t Simulation::state_hash() const { return core_->model->hash(); }

}  // namespace spoke
