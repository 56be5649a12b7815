// Calculates energies, work and the values of all sensors at a step.

#include "engine/simulation/sensors.h"

#include <utility>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/readings.h"
#include "engine/bodies/kernels/samples.h"

namespace spoke {
namespace {

/// Returns the hub's energies: kinetic, and the work of gravity.
Energies calc_hub_energies(const System<Plane>& system, const Twist& position,
                           const Twist& velocity) {
  const Hub& hub = system.hub;
  const Position v = velocity.head<kPosition>(), p = position.head<kPosition>();
  const double speed = velocity[kRotation];
  return {0.5 * hub.mass * v.squaredNorm() + 0.5 * hub.inertia * speed * speed, 0.0,
          system.gravity_ramp > 0.0 ? 0.0 : hub.mass * system.gravity.dot(p)};
}

Energies calc_hub_energies(const System<Plane>& system, const SystemRecord<Plane>& record) {
  return calc_hub_energies(system, record.position, record.velocity);
}

}  // namespace

Energies calc_energies(const System<Plane>& system, StepData<Plane>& data) {
  const CoordinateBlock& hub = data.hub_coordinates;
  if (data.is_coupled) data.hub = calc_hub_state(data);
  Energies energies = calc_hub_energies(system, Twist(hub.q[0], hub.q[1], hub.q[2]),
                                        Twist(hub.v[0], hub.v[1], hub.v[2]));
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    update_kinematics(system.subsystems[i], data.subsystems[i]);
    energies = energies + calc_sample(system, i, data.subsystems[i]);
  }
  return energies;
}

Sensors::Sensors(const System<Plane>& system, std::vector<SensorColumn> asked,
                 std::vector<SensorColumn> momentum)
    : asked_(std::move(asked)), momentum_(system, std::move(momentum)) {
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    const std::string prefix = "blade" + std::to_string(i + 1);
    add(prefix + ".tip.x", "m");
    add(prefix + ".tip.y", "m");
  }
  if (system.hub.support == HubSupport::free) {
    add("hub.x", "m");
    add("hub.y", "m");
  }
  add_hub_columns();
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    const std::string prefix = "blade" + std::to_string(i + 1);
    add(prefix + ".tip.along", "m");
    add(prefix + ".tip.across", "m");
    add(prefix + ".root.x", "N");
    add(prefix + ".root.y", "N");
    add(prefix + ".root.moment", "N m");
  }
  if (momentum_.are_there()) add_momentum_columns();
  for (const SensorColumn& column : asked_) add(column.name, column.unit);
}

void Sensors::start(const System<Plane>& system, StepData<Plane>& data) {
  sample(system, 0, 0.0, data);
  start_balance(sum_energies(calc_hub_energies(system, of_step(data.records, 0)), 0, data));
  momentum_.start(system, data);
}

void Sensors::sample(const System<Plane>& system, std::int64_t step, double t,
                     StepData<Plane>& data) {
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    update_kinematics(system.subsystems[i], data.subsystems[i]);
    update_loops(system, i, t, data);
    sample_subsystem(system, i, step, data);
    calc_readings(system, i, step, t, data);
  }
}

/// Adds tips in the axes of the subsystems, and loads of the roots.
void Sensors::add_subsystem_values(const System<Plane>& system, std::int64_t step,
                                   const StepData<Plane>& data) {
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    const SubsystemSample<Plane>& sample = of_step(data.subsystems[i].samples, step);
    const Position tip = system.subsystems[i].root.R.inverse() * sample.tip;
    const Twist& root = sample.root;
    values_.insert(values_.end(), {tip.x(), tip.y(), root[0], root[1], root[kRotation]});
  }
}

const std::vector<double>& Sensors::measure(const System<Plane>& system, const WorkDone& work,
                                            std::int64_t step, const StepData<Plane>& data) {
  const SystemRecord<Plane>& record = of_step(data.records, step);
  values_.clear();
  for (const SubsystemData<Plane>& subsystem : data.subsystems) {
    const SubsystemSample<Plane>& sample = of_step(subsystem.samples, step);
    values_.insert(values_.end(), {sample.tip.x(), sample.tip.y()});
  }
  if (system.hub.support == HubSupport::free)
    values_.insert(values_.end(), {record.position[0], record.position[1]});
  const double torque = record.reaction[kRotation] + record.applied_torque;
  values_.insert(values_.end(), {record.position[kRotation], record.velocity[kRotation], torque});
  const Energies energies = sum_energies(calc_hub_energies(system, record), step, data);
  append_energies(energies, work);
  add_subsystem_values(system, step, data);
  if (momentum_.are_there()) {
    momentum_.measure(system, energies.kinetic, step, data);
    append_momentum(momentum_.balance());
  }
  for (const SensorColumn& column : asked_)
    values_.push_back(value_of(column, system.hub, step, data));
  return values_;
}

}  // namespace spoke
