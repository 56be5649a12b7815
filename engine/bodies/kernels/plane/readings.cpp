// Evaluates motions, forces and momenta, and resolves them in the frames asked for.

#include "engine/bodies/kernels/readings.h"

#include <cassert>

#include "engine/bodies/kernels/loops/loop_readings.h"
#include "engine/bodies/kernels/plane/section_balance.h"

namespace spoke {
namespace {

Twist together(const Position& p, double rotation) { return {p.x(), p.y(), rotation}; }

/// Returns the rotation from the hub's frame to the frame asked for, other than a section's.
plane::Rotation from_hub(SensorFrame frame, const Subsystem<Plane>& subsystem,
                         const HubState<Plane>& hub) {
  if (frame == SensorFrame::blade) return subsystem.root.R.inverse();
  return frame == SensorFrame::inertial ? hub.R : plane::Rotation{};
}

/// Returns a motion as an observer in the inertial frame has it; displacements are from the place
/// at t = 0, rotations without the hub's.
Twist calc_inertial(SensorQuantity quantity, const plane::RelativeMotion& m, const Position& start,
                    const HubState<Plane>& hub, const Twist& hub_acceleration,
                    const Position& gravity) {
  const double w = hub.twist[kRotation];
  const Position arm = quarter_turn(m.p);
  switch (quantity) {
    case SensorQuantity::velocity: {
      const Position v = Position(hub.twist.head<kPosition>()) + m.v + w * arm;
      return together(hub.R * v, w + m.speed);
    }
    case SensorQuantity::acceleration: {
      const double alpha = hub_acceleration[kRotation];
      const Position a = Position(hub_acceleration.head<kPosition>()) + m.a +
                         2.0 * w * quarter_turn(m.v) + alpha * arm - w * w * m.p;
      return together(gravity + hub.R * a, alpha + m.acceleration);
    }
    default:
      return together(hub.p + hub.R * m.p - start, m.angle);
  }
}

Twist calc_motion(const System<Plane>& system, std::size_t i, const StepData<Plane>& data, double t,
                  const Reading<Plane>& asked) {
  const Subsystem<Plane>& subsystem = system.subsystems[i];
  const SubsystemData<Plane>& own = data.subsystems[i];
  const plane::RelativeMotion m =
      calc_shown_motion(subsystem, own, asked.body, asked.station, asked.section);
  const double x = asked.body * own.bodies[asked.body].model->body->length + asked.section.x;
  const Position start = subsystem.root.p + subsystem.root.R * Position{x, 0.0};
  if (asked.frame == SensorFrame::inertial)
    return calc_inertial(asked.quantity, m, start, *own.hub,
                         plane::calc_hub_acceleration(system, i, data, t), system.gravity_at(t));
  const plane::Rotation R = from_hub(asked.frame, subsystem, *own.hub);
  if (asked.quantity == SensorQuantity::velocity) return together(R * m.v, m.speed);
  if (asked.quantity == SensorQuantity::acceleration) return together(R * m.a, m.acceleration);
  return together(R * Position(m.p - start), m.angle);
}

bool is_at_root(const Reading<Plane>& asked) { return asked.body == 0 && asked.section.x == 0.0; }

/// Returns a section's load, resolved. At the root it is the load that the hub feels.
Twist calc_force(const System<Plane>& system, std::size_t i, const StepData<Plane>& data, double t,
                 const Reading<Plane>& asked) {
  const Subsystem<Plane>& subsystem = system.subsystems[i];
  const SubsystemData<Plane>& own = data.subsystems[i];
  if (is_at_root(asked)) {
    // The first section stands as the bracket does.
    if (asked.frame == SensorFrame::section || asked.frame == SensorFrame::blade)
      return own.root_load;
    return from_hub(asked.frame, subsystem, *own.hub) * (subsystem.root.R * own.root_load);
  }
  const Twist load =
      calc_section_load(system, i, data, t, asked.body, asked.section, *asked.masses[0]);
  if (asked.frame == SensorFrame::section) {
    const double angle =
        section_values(asked.section, own.bodies[asked.body].coordinates.q)[kRotation];
    return plane::Rotation::from_angle(angle).inverse() * load;
  }
  return from_hub(asked.frame, subsystem, *own.hub) * (own.poses[asked.body].R * load);
}

/// Returns the reaction or the opening of a loop, resolved.
Twist calc_of_loop(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                   double t, const Reading<Plane>& asked) {
  const auto in_plane = [](const space::Twist& vector) {
    return Twist(vector[0], vector[1], vector[Space::kAxial]);
  };
  const LoopVector found = calc_loop_reading(system, i, t, asked, data);
  if (asked.frame == SensorFrame::loop) return in_plane(found.in_loop);
  return from_hub(asked.frame, system.subsystems[i], *data.subsystems[i].hub) *
         in_plane(found.in_hub);
}

Twist calc_reading(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                   double t, const Reading<Plane>& asked) {
  const SubsystemData<Plane>& own = data.subsystems[i];
  switch (asked.quantity) {
    case SensorQuantity::section_force:
      return calc_force(system, i, data, t, asked);
    case SensorQuantity::joint_reaction:
      return from_hub(asked.frame, system.subsystems[i], *own.hub) *
             (own.poses[asked.body].R * own.joint_loads[asked.body]);
    case SensorQuantity::momentum:
    case SensorQuantity::blade_momentum:
      return plane::calc_momentum(own, asked.masses);
    case SensorQuantity::loop_reaction:
    case SensorQuantity::loop_opening:
      return calc_of_loop(system, i, data, t, asked);
    default:
      return calc_motion(system, i, data, t, asked);
  }
}

}  // namespace

void calc_readings(const System<Plane>& system, std::size_t i, std::int64_t step, double t,
                   StepData<Plane>& data) noexcept {
  assert(i < data.subsystems.size() && step >= 0);
  SubsystemData<Plane>& own = data.subsystems[i];
  for (const Reading<Plane>& asked : own.readings) {
    const Twist value = calc_reading(system, i, data, t, asked);
    double* values = readings_of(own, step) + asked.first;
    for (int c = 0; c < kTwist; ++c) values[c] = value[c];
  }
}

PartList parts_of_readings(std::size_t i, const StepData<Plane>& data) {
  PartList list;
  const SubsystemData<Plane>& own = data.subsystems[i];
  for (const Reading<Plane>& asked : own.readings) {
    const bool is_load = asked.quantity == SensorQuantity::section_force && !is_at_root(asked);
    const bool is_accelerated = is_load || asked.quantity == SensorQuantity::acceleration;
    const bool feels_hub = is_load || asked.frame == SensorFrame::inertial;
    const auto body = static_cast<std::size_t>(asked.body);
    if (is_load) graph::add_to(list, loads_on(i, body, data));
    if (!is_accelerated) continue;
    for (std::size_t j = 0; j <= body; ++j) list.push_back(own.parts.bodies[j].accelerations);
    if (feels_hub && data.is_coupled) list.push_back(data.parts.hub_coordinates);
  }
  return list;
}

}  // namespace spoke
