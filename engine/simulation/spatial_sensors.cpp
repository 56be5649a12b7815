// Tips, joints, loads of the roots, hub and energies of a system in space.

#include "engine/simulation/spatial_sensors.h"

#include <algorithm>
#include <array>

namespace spoke {
namespace {

/// "blade 1" as "blade1".
std::string sensor_name_of(const spatial::Tree& tree) {
  std::string name = tree.name;
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name;
}

/// The hub's energies: kinetic, and the work of gravity.
Energies calc_hub_energies(const System<Space>& system, const SystemRecord<Space>& record) {
  const space::Hub& hub = system.hub;
  space::Twist twist = record.velocity;
  linear(twist) = record.hub_rotation.inverse() * space::Position(linear(record.velocity));
  Energies energies;
  energies.kinetic = 0.5 * twist.dot(hub.inertia * twist);
  if (system.gravity_ramp == 0.0) {
    const space::Position centre_moment(hub.inertia.rt(2, 1), hub.inertia.rt(0, 2),
                                        hub.inertia.rt(1, 0));
    energies.gravity = system.gravity.dot(hub.mass * space::Position(linear(record.position)) +
                                          record.hub_rotation * centre_moment);
  }
  return energies;
}

}  // namespace

SpatialSensors::SpatialSensors(const System<Space>& system,
                               const std::vector<spatial::Tree>& trees) {
  for (const spatial::Tree& tree : trees)
    for (const char* axis : {"x", "y", "z"}) add(sensor_name_of(tree) + ".tip." + axis, "m");
  if (system.hub.support == HubSupport::free) {
    for (const char* axis : {"x", "y", "z"}) add(std::string("hub.") + axis, "m");
    for (const char* axis : {"x", "y", "z"}) add(std::string("hub.rotation.") + axis, "rad");
    for (const char* axis : {"x", "y", "z"}) add(std::string("hub.spin.") + axis, "rad/s");
  }
  add_hub_columns();
  for (const spatial::Tree& tree : trees) {
    const std::string name = sensor_name_of(tree);
    for (const char* axis : {"x", "y", "z"}) add(name + ".root.force." + axis, "N");
    for (const char* axis : {"x", "y", "z"}) add(name + ".root.moment." + axis, "N m");
    add_joints(name, tree);
  }
}

/// A joint of one coordinate by its name; of more by number.
void SpatialSensors::add_joints(const std::string& tree_name, const spatial::Tree& tree) {
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    const spatial::Joint& joint = tree.bodies[j].joint;
    const int count = count_coordinates(joint.kind);
    const std::string name =
        tree_name + "." + (joint.name.empty() ? "joint" + std::to_string(j + 1) : joint.name);
    for (int c = 0; c < count; ++c) {
      const bool slides = joint.kind == spatial::JointKind::prismatic ||
                          (joint.kind == spatial::JointKind::cylindrical && c == 1);
      add(count == 1 ? name : name + "." + std::to_string(c + 1), slides ? "m" : "rad");
    }
  }
}

void SpatialSensors::start(const System<Space>& system, const StepData<Space>& data) {
  start_balance(sum_energies(calc_hub_energies(system, of_step(data.records, 0)), 0, data));
}

const std::vector<double>& SpatialSensors::measure(const System<Space>& system,
                                                   const WorkDone& work, std::int64_t step,
                                                   const StepData<Space>& data) {
  const SystemRecord<Space>& record = of_step(data.records, step);
  const auto append = [this](const auto& vector) {
    for (const double value : vector) values_.push_back(value);
  };
  values_.clear();
  for (const SubsystemData<Space>& subsystem : data.subsystems)
    append(of_step(subsystem.samples, step).tip);
  if (system.hub.support == HubSupport::free) {
    append(space::Position(linear(record.position)));
    append(logarithm(record.hub_rotation));
    append(space::Angular(angular(record.velocity)));
    append(std::array{logarithm(record.hub_rotation).norm(), angular(record.velocity).norm()});
  } else {
    append(std::array{record.position[Space::kAxial], record.velocity[Space::kAxial]});
  }
  const double torque = record.reaction[Space::kAxial] + record.applied_torque;
  values_.push_back(torque);
  append_energies(sum_energies(calc_hub_energies(system, record), step, data), work);
  for (const SubsystemData<Space>& subsystem : data.subsystems) {
    append(of_step(subsystem.samples, step).root);
    const double* joints = readings_of(subsystem, step);
    values_.insert(values_.end(), joints, joints + subsystem.reading_count);
  }
  return values_;
}

}  // namespace spoke
