// Measures tips, joints, loads of the roots, hub and energies of a system in space.

#include "engine/simulation/spatial_sensors.h"

#include <array>
#include <utility>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "models/tree/sensor_place.h"

namespace spoke {
namespace {

/// Returns the hub's energies: kinetic, and the work of gravity.
Energies calc_hub_energies(const System<Space>& system, const SystemRecord<Space>& record) {
  const space::Hub& hub = system.hub;
  const space::Twist twist = calc_recorded_twist(record);
  Energies energies;
  energies.kinetic = 0.5 * twist.dot(hub.inertia * twist);
  if (system.gravity_ramp == 0.0) {
    const space::Position centre_moment(hub.inertia.rt()(2, 1), hub.inertia.rt()(0, 2),
                                        hub.inertia.rt()(1, 0));
    energies.gravity = system.gravity.dot(hub.mass * space::Position(linear(record.position)) +
                                          record.hub_rotation * centre_moment);
  }
  return energies;
}

}  // namespace

SpatialSensors::SpatialSensors(const System<Space>& system, const std::vector<spatial::Tree>& trees,
                               const StepData<Space>& data, std::vector<SensorColumn> asked,
                               std::vector<SensorColumn> momentum)
    : asked_(std::move(asked)), momentum_(system, std::move(momentum)) {
  for (const spatial::Tree& tree : trees)
    for (const char* axis : {"x", "y", "z"}) add(sensor_name_of(tree) + ".tip." + axis, "m");
  const bool has_rotor = !system.rotors.empty();
  if (has_rotor)
    for (const char* axis : {"x", "y", "z"}) add(std::string("hub.") + axis, "m");
  if (system.hub.support == HubSupport::free) {
    const std::string name = has_rotor ? "fuselage." : "hub.";
    for (const char* axis : {"x", "y", "z"}) add(name + axis, "m");
    for (const char* axis : {"x", "y", "z"}) add(name + "rotation." + axis, "rad");
    for (const char* axis : {"x", "y", "z"}) add(name + "spin." + axis, "rad/s");
  }
  add_hub_columns();
  for (const spatial::Tree& tree : trees) {
    const std::string name = sensor_name_of(tree);
    for (const char* axis : {"x", "y", "z"}) add(name + ".root.force." + axis, "N");
    for (const char* axis : {"x", "y", "z"}) add(name + ".root.moment." + axis, "N m");
    add_joints(tree);
  }
  add_other_hubs(system.rotors.size(), trees);
  add_actors(ColumnPlace::behind_joints, data);
  if (momentum_.are_there()) add_momentum_columns();
  add_actors(ColumnPlace::last, data);
  for (const SensorColumn& column : asked_) add(column.name, column.unit);
}

void SpatialSensors::add_other_hubs(std::size_t rotors, const std::vector<spatial::Tree>& trees) {
  for (std::size_t r = 1; r < rotors; ++r) {
    const spatial::BodyAt hub = find_hub(trees, static_cast<int>(r));
    const std::string& name = trees[hub.tree].bodies[hub.body].name;
    for (const char* axis : {".x", ".y", ".z"}) add(name + axis, "m");
    add(name + ".angle", "rad");
    add(name + ".speed", "rad/s");
    add(name + ".torque", "N m");
  }
}

void SpatialSensors::add_joints(const spatial::Tree& tree) {
  const std::vector<std::string> names = joint_columns_of(tree);
  std::size_t k = 0;
  for (const spatial::TreeBody& body : tree.bodies)
    for (int c = 0; c < count_coordinates(body.joint.kind); ++c) {
      add(names[k++], slides(body.joint.kind, c) ? "m" : "rad");
    }
  joint_values_.push_back(names.size());
}

void SpatialSensors::add_actors(ColumnPlace place, const StepData<Space>& data) {
  for (const auto& actor : data.actors)
    for (ActorColumn& column : actor->columns(place))
      add(std::move(column.name), std::move(column.unit));
}

void SpatialSensors::append_actors(ColumnPlace place, std::int64_t step,
                                   const StepData<Space>& data) {
  kept_.clear();
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    kept_.push_back(readings_of(data.subsystems[i], step) + joint_values_[i]);
  for (const auto& actor : data.actors) {
    actor->append_values(place, step, kept_, values_);
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] += actor->count_values(i);
  }
}

void SpatialSensors::start(const System<Space>& system, const StepData<Space>& data) {
  start_balance(sum_energies(calc_hub_energies(system, of_step(data.records, 0)), 0, data));
  momentum_.start(system, data);
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
  const RotorRecord<Space>* const rotor =
      system.rotors.empty() ? nullptr : &of_step(data.rotors.front().records, step);
  if (rotor) append(space::Position(linear(rotor->position)));
  if (system.hub.support == HubSupport::free) {
    append(space::Position(linear(record.position)));
    append(logarithm(record.hub_rotation));
    append(space::Angular(angular(record.velocity)));
  }
  if (rotor) {
    append(std::array{rotor->position[Space::kAxial], rotor->velocity[Space::kAxial]});
  } else if (system.hub.support == HubSupport::free) {
    append(std::array{logarithm(record.hub_rotation).norm(), angular(record.velocity).norm()});
  } else {
    append(std::array{record.position[Space::kAxial], record.velocity[Space::kAxial]});
  }
  values_.push_back(rotor ? rotor->reaction[Space::kAxial] + rotor->applied_torque
                          : record.reaction[Space::kAxial] + record.applied_torque);
  const Energies energies = sum_energies(calc_hub_energies(system, record), step, data);
  append_energies(energies, work);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    append(of_step(data.subsystems[i].samples, step).root);
    const double* joints = readings_of(data.subsystems[i], step);
    values_.insert(values_.end(), joints, joints + joint_values_[i]);
  }
  for (std::size_t r = 1; r < data.rotors.size(); ++r) {
    const RotorRecord<Space>& other = of_step(data.rotors[r].records, step);
    append(space::Position(linear(other.position)));
    append(std::array{other.position[Space::kAxial], other.velocity[Space::kAxial],
                      other.reaction[Space::kAxial] + other.applied_torque});
  }
  append_actors(ColumnPlace::behind_joints, step, data);
  if (momentum_.are_there()) {
    momentum_.measure(system, energies.kinetic, step, data);
    append_momentum(momentum_.balance());
  }
  append_actors(ColumnPlace::last, step, data);
  for (const SensorColumn& column : asked_)
    values_.push_back(value_of(column, system.hub, step, data));
  return values_;
}

}  // namespace spoke
