// Evaluates motions, forces and momenta of spatial subsystems, and resolves them in the frames
// asked for.

#include "engine/bodies/kernels/readings.h"

#include <cassert>
#include <optional>

#include "engine/bodies/kernels/loops/loop_readings.h"
#include "engine/bodies/kernels/marker_motion.h"
#include "engine/bodies/kernels/space/interface_force.h"
#include "engine/bodies/kernels/space/relative_motion.h"
#include "engine/bodies/kernels/space/section_balance.h"
#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/bodies/kernels/wind_at.h"

namespace spoke {
namespace {

using space::Angular;
using space::Rotation;

/// Returns the rotation from the hub's frame to the frame asked for, other than a section's.
Rotation from_hub(SensorFrame frame, const Subsystem<Space>& subsystem,
                  const HubState<Space>& hub) {
  if (frame == SensorFrame::blade) return subsystem.root.R.inverse();
  return frame == SensorFrame::inertial ? hub.R : Rotation{};
}

/// Returns where H of the hub that carries a subsystem is when its angle and all joint coordinates
/// of a support are 0, without a mount's motion.
space::Pose calc_start(const System<Space>& system, const Subsystem<Space>& subsystem) {
  space::Pose base{system.hub.position, rotation_of(system.hub, 0.0)};
  if (subsystem.rotor < 0) return base;
  const SupportedRotor& rotor = system.rotors[static_cast<std::size_t>(subsystem.rotor)];
  const Subsystem<Space>& carrier = system.subsystems[static_cast<std::size_t>(rotor.subsystem)];
  const space::Pose hub = calc_rest_pose(carrier, rotor.body);
  if (carrier.rotor >= 0) base = calc_start(system, carrier);
  return {base.p + base.R * hub.p, base.R * hub.R};
}

/// Returns a motion as an observer in the inertial frame has it. start: of H, see calc_start().
space::Twist calc_inertial(SensorQuantity quantity, const SpatialMotion& m, const space::Pose& rest,
                           const space::Pose& start, const HubState<Space>& hub,
                           const space::Twist& hub_acceleration, const space::Position& gravity) {
  const Angular w = angular(hub.twist);
  switch (quantity) {
    case SensorQuantity::velocity:
      return hub.R *
             space::make_twist(space::Position(linear(hub.twist)) + m.v + cross(w, m.p), w + m.w);
    case SensorQuantity::acceleration: {
      const Angular alpha = angular(hub_acceleration);
      const space::Position a = space::Position(linear(hub_acceleration)) + m.a +
                                2.0 * cross(w, m.v) + cross(alpha, m.p) + centripetal(w, m.p);
      return space::make_twist(gravity + hub.R * a,
                               hub.R * Angular(alpha + m.alpha + cross(w, m.w)));
    }
    default:
      return space::make_twist(hub.p + hub.R * m.p - (start.p + start.R * rest.p),
                               logarithm(hub.R * m.R * (start.R * rest.R).inverse()));
  }
}

space::Twist calc_motion(const System<Space>& system, std::size_t i, const StepData<Space>& data,
                         double t, const Reading<Space>& asked) {
  const Subsystem<Space>& subsystem = system.subsystems[i];
  const SubsystemData<Space>& own = data.subsystems[i];
  const space::Twist hub_acceleration = is_accelerated(asked)
                                            ? calc_hub_acceleration(system, i, data, t)
                                            : space::Twist(space::Twist::Zero());
  const SpatialMotion m = calc_shown_motion(subsystem, own, hub_acceleration, asked);
  if (asked.frame == SensorFrame::inertial)
    return calc_inertial(asked.quantity, m, asked.rest, calc_start(system, subsystem), *own.hub,
                         hub_acceleration, system.gravity_at(t));
  const Rotation R = from_hub(asked.frame, subsystem, *own.hub);
  if (asked.quantity == SensorQuantity::velocity) return R * space::make_twist(m.v, m.w);
  if (asked.quantity == SensorQuantity::acceleration) return R * space::make_twist(m.a, m.alpha);
  return R * space::make_twist(m.p - asked.rest.p, logarithm(m.R * asked.rest.R.inverse()));
}

/// Returns a section's load, resolved; at the root it is the load that the hub feels.
space::Twist calc_force(const System<Space>& system, std::size_t i, const StepData<Space>& data,
                        double t, const Reading<Space>& asked) {
  const Subsystem<Space>& subsystem = system.subsystems[i];
  const SubsystemData<Space>& own = data.subsystems[i];
  const auto j = static_cast<std::size_t>(asked.body());
  const Rotation& R_HB = own.poses[j].R;
  space::Twist load;
  if (asked.is_root()) {
    load = -own.joint_loads[j];
  } else {
    const space::Twist X = calc_frame_acceleration(
        subsystem, own, calc_hub_acceleration(system, i, data, t), asked.path);
    load = calc_section_load(subsystem, own, t, X, asked);
  }
  if (asked.frame != SensorFrame::section)
    return from_hub(asked.frame, subsystem, *own.hub) * (R_HB * load);
  const Rotation section = motion_at(own.bodies[j], asked.section).turn.R * asked.section.axes;
  return section.inverse() * load;
}

/// Returns the reaction or the opening of a loop, resolved.
space::Twist calc_of_loop(const System<Space>& system, std::size_t i, const StepData<Space>& data,
                          double t, const Reading<Space>& asked) {
  const LoopVector found = calc_loop_reading(system, i, t, asked, data);
  if (asked.frame == SensorFrame::loop) return found.in_loop;
  return from_hub(asked.frame, system.subsystems[i], *data.subsystems[i].hub) * found.in_hub;
}

/// Returns the wind at a place.
space::Twist calc_wind(const System<Space>& system, std::size_t i, const StepData<Space>& data,
                       double t, const Reading<Space>& asked) {
  const SubsystemData<Space>& own = data.subsystems[i];
  const SpatialMotion m = calc_shown_motion(system.subsystems[i], own, space::Twist::Zero(), asked);
  const space::Position place = own.hub->p + own.hub->R * m.p;
  return space::make_twist(space::Position(find_wind(*system.wind, place, t)), Angular::Zero());
}

/// Returns the value of a sensor that an actor shows.
space::Twist read_actor(std::size_t i, const StepData<Space>& data, const Reading<Space>& asked) {
  for (const auto& actor : data.actors)
    if (const std::optional<space::Twist> value = actor->read(i, asked)) return *value;
  assert(!"an actor shows the quantity");
  return space::Twist::Zero();
}

space::Twist calc_reading(const System<Space>& system, std::size_t i, const StepData<Space>& data,
                          double t, const Reading<Space>& asked) {
  const SubsystemData<Space>& own = data.subsystems[i];
  switch (asked.quantity) {
    case SensorQuantity::section_force:
      return calc_force(system, i, data, t, asked);
    case SensorQuantity::joint_reaction: {
      const auto j = static_cast<std::size_t>(asked.body());
      return from_hub(asked.frame, system.subsystems[i], *own.hub) *
             (own.poses[j].R * own.joint_loads[j]);
    }
    case SensorQuantity::interface_force: {
      const auto j = static_cast<std::size_t>(asked.body());
      return from_hub(asked.frame, system.subsystems[i], *own.hub) *
             (own.poses[j].R * calc_interface_force(system, i, t, asked, data));
    }
    case SensorQuantity::von_mises: {
      const double* q = own.bodies[static_cast<std::size_t>(asked.body())].coordinates.q;
      return space::Twist::Unit(0) * asked.recovery->largest_von_mises(q).value;
    }
    case SensorQuantity::air_flow:
    case SensorQuantity::air_load:
      return read_actor(i, data, asked);
    case SensorQuantity::wind:
      return calc_wind(system, i, data, t, asked);
    case SensorQuantity::momentum:
    case SensorQuantity::blade_momentum:
      return calc_momentum(own);
    case SensorQuantity::loop_reaction:
    case SensorQuantity::loop_opening:
      return calc_of_loop(system, i, data, t, asked);
    case SensorQuantity::coupling_force:
      return own.loops.kept_multipliers[static_cast<std::size_t>(
                 own.loops.paths[asked.loop].first_row)] *
             space::Twist::Unit(0);
    default:
      return calc_motion(system, i, data, t, asked);
  }
}

}  // namespace

void calc_readings(const System<Space>& system, std::size_t i, std::int64_t step, double t,
                   StepData<Space>& data) noexcept {
  assert(i < data.subsystems.size() && step >= 0);
  SubsystemData<Space>& own = data.subsystems[i];
  for (const Reading<Space>& asked : own.readings) {
    const space::Twist value = calc_reading(system, i, data, t, asked);
    double* values = readings_of(own, step) + asked.first;
    for (int c = 0; c < space::kTwist; ++c) values[c] = value[c];
  }
}

PartList parts_of_readings(std::size_t i, const StepData<Space>& data) {
  PartList list;
  const SubsystemData<Space>& own = data.subsystems[i];
  for (const Reading<Space>& asked : own.readings) {
    const bool is_load = asked.quantity == SensorQuantity::section_force && !asked.is_root();
    if (is_load) graph::add_to(list, loads_on(i, static_cast<std::size_t>(asked.body()), data));
    if (!is_load && !is_accelerated(asked)) continue;
    for (const int j : asked.path)
      list.push_back(own.parts.bodies[static_cast<std::size_t>(j)].accelerations);
    if (data.is_coupled && own.rotor < 0) list.push_back(data.parts.hub_coordinates);
  }
  return list;
}

}  // namespace spoke
