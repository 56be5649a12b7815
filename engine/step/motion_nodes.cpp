// Declares what these nodes read and write, and adds them.

#include "engine/step/motion_nodes.h"

#include <algorithm>
#include <utility>

#include "engine/bodies/kernels/applied_forces.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/modal_damping.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/step/pass_integration.h"

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::updates;
using graph::writes;

}  // namespace

template <class World>
void add_hub_motion(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  const SystemParts& parts = g.parts();
  g.builder.add_node(g.label(c.system.rotors.empty() ? stages::kHubMotion : stages::kSupportMotion),
                     reads(parts.progress), updates(parts.hub_coordinates, parts.hub_history),
                     writes(parts.hub_state), unless_halted(c.data.progress[0], [&c]() noexcept {
                       begin_hub(c.system, c.integrator.method, c.data);
                     }));
}

template <class World>
void add_rotor_motion(const Assembly<World>& g, int r) {
  const auto index = static_cast<std::size_t>(r);
  SystemContext<World>& c = g.c;
  const PartId hub = g.parts().rotors[index].hub;
  const bool has_implicit = std::holds_alternative<GeneralizedAlpha>(c.integrator.method);
  StepProgress& progress = c.data.progress[0];
  g.builder.add_node(
      label_of_rotor(g, stages::kHubMotion, r),
      reads(g.parts().progress, parts_of_rotor_place(c.system, index, has_implicit, c.data)),
      updates(hub), unless_halted(progress, [&c, &progress, index]() noexcept {
        place_rotor(c.system, index, progress.control.time, progress.control.is_implicit, c.data);
      }));
}

template <class World>
void add_prescribed_hub_motion(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  const SubsystemData<World>& data = g.c.data.subsystems[i];
  const SystemContext<World>& c = g.c;
  PrescribedHub<World>& prescribed = g.c.data.subsystems[i].prescribed;
  g.builder.add_node(
      g.label(stages::kHubMotion, i), reads(own.progress), updates(own.hub_state),
      unless_halted(*data.progress, [&c, &prescribed, &progress = *data.progress]() noexcept {
        if (is_at_new_time(c.integrator.method, progress.control))
          prescribed = calc_prescribed_motion(c.system, progress.control.time);
      }));
}

template <class World>
void add_coordinates(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  const PartList coordinates = own.all(&BodyParts::coordinates);
  const PartList history = own.all(&BodyParts::history);
  const PartList accelerations = own.all(&BodyParts::accelerations);
  const Method& method = g.c.integrator.method;
  PartList predicted;
  if (std::holds_alternative<GeneralizedAlpha>(method)) predicted = accelerations;
  SubsystemData<World>& data = g.c.data.subsystems[i];
  g.builder.add_node(
      g.label(stages::kCoordinates, i), reads(own.progress, accelerations),
      updates(coordinates, history), writes(predicted),
      unless_halted(*data.progress, [&method, &data]() noexcept { begin_bodies(method, data); }));
}

template <class World>
void add_position(const Assembly<World>& g, int i) {
  const Subsystem<World>& subsystem = g.c.system.subsystems[i];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  const SubsystemParts& own = g.subsystem(i);
  PartList handles;
  if constexpr (tree::kHasJointCoordinates<World>) handles.push_back(own.rotations);
  g.builder.add_node(g.label(stages::kPosition, i), reads(own.progress, parts_of_rotations(data)),
                     updates(handles), writes(own.rotations),
                     unless_halted(*data.progress, [&subsystem, &data]() noexcept {
                       calc_rotations(subsystem, data);
                     }));
}

template <class World>
void add_velocity(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  const System<World>& system = g.c.system;
  const Subsystem<World>& subsystem = system.subsystems[i];
  StepData<World>& table = g.c.data;
  SubsystemData<World>& data = table.subsystems[i];
  const auto index = static_cast<std::size_t>(i);
  PartList outputs{own.twists};
  if (!data.drag_poses.empty()) outputs.push_back(own.drag_poses);
  if constexpr (tree::kHasJointCoordinates<World>)
    outputs.push_back(own.rotations);  // the node sets the joints, too
  if (!data.modal_forces.empty()) outputs.push_back(own.modal_forces);
  const bool has_tension = needs_angular_accelerations(data);
  g.builder.add_node(g.label(stages::kVelocity, i),
                     reads(own.progress, parts_of_prescribed_joints(system, index, table),
                           parts_of_velocities(data), parts_of_angular_accelerations(index, table),
                           parts_of_modal_forces(data)),
                     writes(outputs),
                     unless_halted(*data.progress, [&system, &subsystem, &table, &data, index,
                                                    has_tension]() noexcept {
                       prescribe_joints(system, data.progress->control.time, index, table);
                       calc_velocities(subsystem, data);
                       if (has_tension) set_angular_accelerations(system, index, table);
                       if (!data.modal_forces.empty()) calc_modal_forces(subsystem, data);
                       if (!data.drag_poses.empty()) calc_poses(subsystem, data, data.drag_poses);
                     }));
}

template <class World>
void add_applied_forces(const Assembly<World>& g, int i) {
  StepData<World>& table = g.c.data;
  const auto index = static_cast<std::size_t>(i);
  SubsystemData<World>& data = table.subsystems[index];
  if (data.applied_forces.empty()) return;
  g.builder.add_node(
      g.label(stages::kAppliedForces, i),
      reads(data.parts.progress, parts_of_applied_forces(index, table)),
      writes(data.parts.applied_forces),
      unless_halted(*data.progress, [&system = g.c.system, &table, &data, index]() noexcept {
        calc_applied_forces(system, index, data.progress->control.time, table);
      }));
}

template <class World>
void add_flight_acceleration(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  const std::vector<SubsystemData<World>>& subsystems = c.data.subsystems;
  if (std::none_of(subsystems.begin(), subsystems.end(), [](const SubsystemData<World>& data) {
        return data.flight_acceleration != nullptr;
      }))
    return;
  g.builder.add_node(g.label(stages::kFlightAcceleration),
                     reads(g.parts().progress, parts_of_flight_acceleration(c.data)),
                     writes(g.parts().flight_acceleration),
                     unless_halted(c.data.progress[0], [&c]() noexcept {
                       calc_flight_acceleration(c.system, c.data.progress[0].control.time, c.data);
                     }));
}

template void add_hub_motion(const Assembly<Plane>&);
template void add_rotor_motion(const Assembly<Plane>&, int);
template void add_rotor_motion(const Assembly<Space>&, int);
template void add_prescribed_hub_motion(const Assembly<Plane>&, int);
template void add_coordinates(const Assembly<Plane>&, int);
template void add_position(const Assembly<Plane>&, int);
template void add_velocity(const Assembly<Plane>&, int);
template void add_applied_forces(const Assembly<Plane>&, int);
template void add_flight_acceleration(const Assembly<Plane>&);
template void add_hub_motion(const Assembly<Space>&);
template void add_prescribed_hub_motion(const Assembly<Space>&, int);
template void add_coordinates(const Assembly<Space>&, int);
template void add_position(const Assembly<Space>&, int);
template void add_velocity(const Assembly<Space>&, int);
template void add_applied_forces(const Assembly<Space>&, int);
template void add_flight_acceleration(const Assembly<Space>&);

}  // namespace spoke
