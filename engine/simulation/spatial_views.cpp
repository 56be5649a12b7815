// Markers, reactions and section forces of trees in space.

#include "engine/simulation/spatial_views.h"

#include "engine/kernels/kinematics.h"
#include "engine/kernels/load_terms.h"
#include "engine/kernels/marker_motion.h"
#include "engine/kernels/spatial_relative_motion.h"
#include "models/error.h"

namespace spoke {
namespace {

Wrench make(const space::Twist& wrench) {
  return {space::Position(linear(wrench)), space::Angular(angular(wrench))};
}

}  // namespace

MarkerState calc_marker_state(const SystemContext<Space>& context, const Marker& marker, double t) {
  const PlacedMarker<Space> placed = place_marker("the marker", marker, context.data);
  const auto tree = static_cast<std::size_t>(marker.blade);
  const Subsystem<Space>& subsystem = context.system.subsystems[tree];
  const SubsystemData<Space>& data = context.data.subsystems[tree];
  MarkerState state{calc_marker_motion(subsystem, data, placed)};
  const space::Twist acceleration =
      calc_marker_acceleration(context.system.gravity_at(t), subsystem, data, placed);
  state.acceleration = linear(acceleration);
  state.angular_acceleration = angular(acceleration);
  const space::Pose rest = calc_rest_pose(subsystem, marker.body);
  state.deflection = data.hub->R.inverse() * space::Position(state.position - data.hub->p) -
                     (rest.p + rest.R * placed.section.s0);
  state.foreshortening = calc_marker_foreshortening(subsystem, data, placed);
  return state;
}

Wrench calc_joint_reaction(const SystemContext<Space>& context, int blade, int joint) {
  const auto tree = static_cast<std::size_t>(blade);
  const SubsystemData<Space>& data = context.data.subsystems[tree];
  return make(data.hub->R * (calc_rotation_to_hub(context.system.subsystems[tree], data, joint) *
                             data.wrenches[static_cast<std::size_t>(joint)].inboard));
}

Wrench calc_hub_reaction(const StepData<Space>& data) {
  space::Twist wrench = data.evaluated.reaction;
  wrench[Space::kAxial] += data.evaluated.applied_torque;
  const HubState<Space>& hub = data.is_coupled ? data.hub : *data.subsystems.front().hub;
  return make(hub.R * wrench);
}

Wrench calc_section_force(const SystemContext<Space>& context, const Marker& marker) {
  const PlacedMarker<Space> placed = place_marker("the marker", marker, context.data);
  const BodyData<Space>& body = context.data.subsystems[static_cast<std::size_t>(marker.blade)]
                                    .bodies[static_cast<std::size_t>(marker.body)];
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (!flexible)
    throw InputError("section_force(): the marker is on a rigid body, expected one on a beam");
  const auto resultants = [&](const double* flex) {
    return calc_section_load(*flexible, placed.section, flex).resultants;
  };
  return make(resultants(body.coordinates.q) +
              context.system.damping.stiffness_factor * resultants(body.coordinates.v));
}

MarkerState calc_hub_frame(const SystemContext<Space>& context, double t) {
  const HubState<Space> hub = calc_hub_state(context.data);
  const space::Twist velocity = hub.R * hub.twist;
  const space::Twist acceleration =
      hub.R * calc_hub_acceleration(context.system, 0, context.data, t);
  MarkerState frame;
  frame.velocity = linear(velocity);
  frame.angular_velocity = angular(velocity);
  frame.acceleration = space::Position(linear(acceleration)) + context.system.gravity_at(t);
  frame.angular_acceleration = angular(acceleration);
  return frame;
}

}  // namespace spoke
