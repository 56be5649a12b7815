// Views of markers, reactions and section forces of both worlds, in vectors of space.

#include "engine/simulation/views.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "engine/bodies/act/user_load/load_markers.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/anchor_motion.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/loops/loop_readings.h"
#include "engine/bodies/kernels/marker_motion.h"
#include "engine/bodies/kernels/modal_damping.h"
#include "engine/bodies/kernels/space/relative_motion.h"
#include "engine/bodies/plane/section.h"
#include "engine/bodies/table/body_kind.h"
#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

Wrench wrench_in_space(const Twist& wrench) {
  return {{wrench[0], wrench[1], 0.0}, {0.0, 0.0, wrench[kRotation]}};
}
Wrench wrench_in_space(const space::Twist& wrench) {
  return {space::Position(linear(wrench)), space::Angular(angular(wrench))};
}

/// Returns the hub that an anchor, or the mount (-1), moves against: of a rotor on a support its
/// own for anchors of the frames "hub" and "axle", what the support stands on for all others.
template <class World>
HubState<World> find_carrier_hub(const SystemContext<World>& context, const AnchorModel* anchor) {
  const bool is_of_rotor =
      !context.data.rotors.empty() && anchor && anchor->frame != Anchor::Frame::mount;
  return is_of_rotor ? context.data.rotors[static_cast<std::size_t>(anchor->rotor)].hub
                     : calc_hub_state(context.data);
}

/// Returns the motion of an anchor that moves against a body, as of the first loop that closes on
/// it; none if no loop does.
template <class World>
std::optional<MarkerMotion> calc_on_body(const SystemContext<World>& context, int anchor,
                                         double t) {
  for (std::size_t i = 0; i < context.system.subsystems.size(); ++i)
    for (const LoopModel& loop : context.system.subsystems[i].loops)
      for (LoopPlaceModel place : {loop.from, loop.to}) {
        if (!place.is_moved() || place.anchor != anchor) continue;
        place.offset = {};
        const HubState<World> own = *context.data.subsystems[i].hub;
        const HubState<Space>& hub = hub_in_space(own);
        const PlaceMotion in_hub = calc_place_motion(context.system, i, place, t, context.data);
        const space::Twist velocity = hub.R * in_hub.twist;
        return MarkerMotion{hub.p + hub.R * in_hub.p, (hub.R * in_hub.R).axes, linear(velocity),
                            angular(velocity)};
      }
  return std::nullopt;
}

/// Returns the motion of an anchor, or of the mount (-1).
template <class World>
MarkerMotion calc_carrier(const SystemContext<World>& context, int anchor, double t) {
  if (const auto on_body = calc_on_body(context, anchor, t)) return *on_body;
  LoopPlaceModel place;
  place.carrier = anchor < 0 ? LoopPlace::Carrier::mount : LoopPlace::Carrier::anchor;
  place.anchor = anchor;
  const AnchorModel* const model =
      anchor < 0 ? nullptr : &context.system.anchors[static_cast<std::size_t>(anchor)];
  const HubState<World> own = find_carrier_hub(context, model);
  const HubState<Space>& hub = hub_in_space(own);
  const DriveMotion* axle = nullptr;
  if (!context.data.rotors.empty())
    axle = &context.data.rotors[static_cast<std::size_t>(model ? model->rotor : 0)].turn;
  const PlaceMotion in_hub = calc_carried_place(context.system, own, axle, place, t).motion;
  const space::Twist velocity = hub.R * in_hub.twist;
  return {hub.p + hub.R * in_hub.p, (hub.R * in_hub.R).axes, linear(velocity), angular(velocity)};
}

}  // namespace

MarkerState calc_marker_state(const SystemContext<Plane>& context, const Marker& marker, double t) {
  const PlacedMarker<Plane> placed = place_marker("the marker", marker, context.data);
  const auto index = static_cast<std::size_t>(marker.blade);
  const Subsystem<Plane>& subsystem = context.system.subsystems[index];
  const SubsystemData<Plane>& data = context.data.subsystems[index];
  MarkerState state{calc_marker_motion(subsystem, data, placed)};
  const Twist acceleration = calc_marker_acceleration(context.system.gravity_at(t), data, placed);
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

MarkerState calc_marker_state(const SystemContext<Space>& context, const Marker& marker, double t) {
  const PlacedMarker<Space> placed = place_marker("the marker", marker, context.data);
  const auto index = static_cast<std::size_t>(marker.blade);
  const Subsystem<Space>& subsystem = context.system.subsystems[index];
  const SubsystemData<Space>& data = context.data.subsystems[index];
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

Wrench calc_joint_reaction(const SystemContext<Plane>& context, int subsystem, int joint) {
  assert(subsystem >= 0 && std::cmp_less(subsystem, context.data.subsystems.size()));
  assert(joint >= 0 && std::cmp_less(joint, context.data.subsystems[subsystem].bodies.size()));
  const SubsystemData<Plane>& data = context.data.subsystems[static_cast<std::size_t>(subsystem)];
  const Twist& wrench = data.wrenches[static_cast<std::size_t>(joint)].inboard;
  return wrench_in_space(Twist(data.hub->R * calc_rotation_to_hub(data, joint) * wrench));
}

Wrench calc_joint_reaction(const SystemContext<Space>& context, int subsystem, int joint) {
  assert(subsystem >= 0 && std::cmp_less(subsystem, context.data.subsystems.size()));
  assert(joint >= 0 && std::cmp_less(joint, context.data.subsystems[subsystem].bodies.size()));
  const auto index = static_cast<std::size_t>(subsystem);
  const SubsystemData<Space>& data = context.data.subsystems[index];
  const space::Twist in_hub = calc_rotation_to_hub(context.system.subsystems[index], data, joint) *
                              data.wrenches[static_cast<std::size_t>(joint)].inboard;
  return wrench_in_space(space::Twist(data.hub->R * in_hub));
}

std::size_t find_loop(const std::vector<LoopModel>& loops, const std::string& subsystem,
                      std::string_view name) {
  std::vector<std::string_view> names;
  for (const LoopModel& loop : loops)  // couplings, which are behind all loops, have no places
    if (!loop.is_coupling()) names.push_back(loop.name);
  const auto at = std::find(names.begin(), names.end(), name);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  const auto nearest = nearest_name(name, names);
  throw InputError("no loop of " + subsystem + " is named \"" + std::string(name) + "\"" +
                   (nearest ? ", did you mean \"" + std::string(*nearest) + "\"?" : ""));
}

template <class World>
Wrench calc_loop_wrench(const SystemContext<World>& context, std::size_t i, std::size_t k,
                        double t) {
  const SubsystemData<World>& data = context.data.subsystems[i];
  const LoopVector found =
      calc_loop_reaction(context.system, i, k, t, context.data, data.loops.multipliers);
  return wrench_in_space(space::Twist(hub_in_space(*data.hub).R * found.in_hub));
}
template Wrench calc_loop_wrench(const SystemContext<Plane>&, std::size_t, std::size_t, double);
template Wrench calc_loop_wrench(const SystemContext<Space>&, std::size_t, std::size_t, double);

template <class World>
Wrench calc_hub_reaction(const StepData<World>& data) {
  if constexpr (tree::kHasJointCoordinates<World>)
    if (!data.rotors.empty()) {
      const RotorRecord<World>& rotor = data.rotors.front().evaluated;
      TwistOf<World> wrench = rotor.reaction;
      wrench[World::kAxial] += rotor.applied_torque;
      return wrench_in_space(TwistOf<World>(data.rotors.front().hub.R * wrench));
    }
  TwistOf<World> wrench = data.evaluated.reaction;
  wrench[World::kAxial] += data.evaluated.applied_torque;
  const HubState<World>& hub = data.is_coupled ? data.hub : *data.subsystems.front().hub;
  return wrench_in_space(TwistOf<World>(hub.R * wrench));
}
template Wrench calc_hub_reaction(const StepData<Plane>&);
template Wrench calc_hub_reaction(const StepData<Space>&);

Wrench calc_section_force(const Rotor& rotor, const SystemContext<Plane>& context,
                          const Marker& marker) {
  const PlacedMarker<Plane> placed = place_marker("the marker", marker, context.data);
  const auto index = static_cast<std::size_t>(marker.blade);
  const SubsystemData<Plane>& data = context.data.subsystems[index];
  const BodyData<Plane>& body = data.bodies[static_cast<std::size_t>(marker.body)];
  const std::vector<double> modal =
      calc_modal_deformation(context.system.subsystems[index], data, body);
  return wrench_in_space(calc_section_force(rotor.blades[index], context.system.damping,
                                            modal.empty() ? nullptr : modal.data(), body,
                                            placed.section));
}

Wrench calc_section_force(const SystemContext<Space>& context, const Marker& marker) {
  const PlacedMarker<Space> placed = place_marker("the marker", marker, context.data);
  const auto index = static_cast<std::size_t>(marker.blade);
  const SubsystemData<Space>& data = context.data.subsystems[index];
  const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(marker.body)];
  const std::vector<double> modal =
      calc_modal_deformation(context.system.subsystems[index], data, body);
  const std::optional<space::Twist> stress =
      body.kind->calc_stress(body, placed.section, context.system.damping.stiffness_factor,
                             modal.empty() ? nullptr : modal.data());
  if (!stress)
    throw InputError("section_force(): the marker is on a " + std::string(body.kind->name()) +
                     ", expected one on a beam");
  return wrench_in_space(*stress);
}

MarkerState calc_hub_frame(const SystemContext<Plane>& context, double) {
  const CoordinateBlock& hub = context.data.hub_coordinates;
  MarkerState frame;
  frame.velocity = {hub.v[0], hub.v[1], 0.0};
  frame.angular_velocity = {0.0, 0.0, hub.v[kRotation]};
  frame.acceleration = {hub.a[0], hub.a[1], 0.0};
  frame.angular_acceleration = {0.0, 0.0, hub.a[kRotation]};
  return frame;
}

MarkerState calc_hub_frame(const SystemContext<Space>& context, double t) {
  const std::vector<RotorData<Space>>& rotors = context.data.rotors;
  const HubState<Space> hub = rotors.empty() ? calc_hub_state(context.data) : rotors.front().hub;
  const space::Twist velocity = hub.R * hub.twist;
  const space::Twist acceleration =
      hub.R * (rotors.empty() ? calc_hub_acceleration(context.system, 0, context.data, t)
                              : rotors.front().acceleration);
  MarkerState frame;
  frame.velocity = linear(velocity);
  frame.angular_velocity = angular(velocity);
  frame.acceleration = space::Position(linear(acceleration)) + context.system.gravity_at(t);
  frame.angular_acceleration = angular(acceleration);
  return frame;
}

MarkerMotion calc_carrier_frame(const SystemContext<Plane>& context, int anchor, double t) {
  return calc_carrier(context, anchor, t);
}
MarkerMotion calc_carrier_frame(const SystemContext<Space>& context, int anchor, double t) {
  return calc_carrier(context, anchor, t);
}

}  // namespace spoke
