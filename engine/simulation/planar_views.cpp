// Markers, reactions and section forces in the plane, in vectors of space.

#include "engine/simulation/planar_views.h"

#include "engine/body/section.h"
#include "engine/kernels/kinematics.h"
#include "engine/kernels/load_terms.h"
#include "engine/kernels/marker_motion.h"

namespace spoke {
namespace {

Wrench wrench_in_space(const Twist& wrench) {
  return {{wrench[0], wrench[1], 0.0}, {0.0, 0.0, wrench[kRotation]}};
}

}  // namespace

MarkerState calc_marker_state(const SystemContext<Plane>& context, const Marker& marker, double t) {
  const PlacedMarker<Plane> placed = place_marker("the marker", marker, context.data);
  const auto blade = static_cast<std::size_t>(marker.blade);
  const Subsystem<Plane>& subsystem = context.system.subsystems[blade];
  const SubsystemData<Plane>& data = context.data.subsystems[blade];
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

Wrench calc_joint_reaction(const StepData<Plane>& table, int blade, int joint) {
  const SubsystemData<Plane>& data = table.subsystems[static_cast<std::size_t>(blade)];
  const Twist& wrench = data.wrenches[static_cast<std::size_t>(joint)].inboard;
  return wrench_in_space(data.hub->R * calc_rotation_to_hub(data, joint) * wrench);
}

Wrench calc_hub_reaction(const StepData<Plane>& data) {
  Twist wrench = data.evaluated.reaction;
  wrench[kRotation] += data.evaluated.applied_torque;
  const HubState<Plane>& hub = data.is_coupled ? data.hub : *data.subsystems.front().hub;
  return wrench_in_space(hub.R * wrench);
}

Wrench calc_section_force(const Rotor& rotor, const SystemContext<Plane>& context,
                          const Marker& marker) {
  const PlacedMarker<Plane> placed = place_marker("the marker", marker, context.data);
  const auto blade = static_cast<std::size_t>(marker.blade);
  return wrench_in_space(calc_section_force(
      rotor.blades[blade], context.system.damping,
      context.data.subsystems[blade].bodies[static_cast<std::size_t>(marker.body)],
      placed.section));
}

}  // namespace spoke
