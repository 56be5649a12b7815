// Finds the bodies and sections of sensors, and reads their values from the table.

#include "engine/bodies/columns/sensor_columns.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "engine/bodies/kernels/plane/section_balance.h"

namespace spoke {
namespace {

/// The subsystems on which a sensor reads; all of them for a sensor of the whole system.
struct SubsystemRange {
  std::size_t first, end;
};

SubsystemRange subsystems_of(const Sensor& sensor, std::size_t subsystems) {
  if (sensor.blade.is_all() || !is_of_blade(sensor.quantity)) return {0, subsystems};
  const auto first = static_cast<std::size_t>(sensor.blade.number()) - 1;
  return {first, first + 1};
}

/// Makes the mass points that sensors integrate over, once for all bodies that are alike.
class MassPointMaker {
 public:
  MassPoints outboard_of(double from, const BodyData<Plane>& body) {
    const plane::FlexibleBody& model = *body.model->body;
    MassPoints& made = made_[{&model, from}];
    if (!made)
      made = std::make_shared<const std::vector<MassPoint>>(
          make_mass_points(model, body.layout, from));
    return made;
  }

 private:
  std::map<std::pair<const plane::FlexibleBody*, double>, MassPoints> made_;
};

/// Returns the mass points that a reading integrates over.
std::vector<MassPoints> find_masses(const Reading<Plane>& reading, const SubsystemData<Plane>& data,
                                    MassPointMaker& maker) {
  std::vector<MassPoints> masses;
  if (reading.quantity == SensorQuantity::section_force)
    masses.push_back(maker.outboard_of(reading.section.x, data.bodies[reading.body]));
  if (reading.quantity == SensorQuantity::momentum ||
      reading.quantity == SensorQuantity::blade_momentum)
    for (const BodyData<Plane>& body : data.bodies) masses.push_back(maker.outboard_of(0.0, body));
  return masses;
}

/// Makes a reading. Where two bodies meet it is on the inner one: loads that act there are then
/// outboard of the section.
Reading<Plane> make_reading(const Sensor& sensor, const Blade& blade,
                            const SubsystemData<Plane>& data) {
  constexpr double kSlack = 1e-9;
  Reading<Plane> reading{sensor.quantity, frame_of(sensor), 0, 0.0, {}, 0, data.reading_count, {}};
  if (sensor.quantity == SensorQuantity::joint_reaction) reading.body = sensor.joint->body();
  if (is_of_loop(sensor.quantity)) reading.loop = find_loop(blade.loops, sensor.loop);
  if (!has_position(sensor.quantity)) return reading;
  const double along = sensor.position.value_or(blade.length) / blade.length * blade.bodies;
  reading.body = std::clamp(static_cast<int>(std::ceil(along - kSlack)) - 1, 0, blade.bodies - 1);
  const double station = std::min(along - reading.body, 1.0);
  reading.station = station > 1.0 - kSlack ? 1.0 : station;
  const BodyData<Plane>& body = data.bodies[reading.body];
  reading.section = make_section(*body.model->body, body.layout, reading.station);
  return reading;
}

/// Adds the readings of a sensor, and returns their places.
std::vector<std::size_t> add_readings(const Sensor& sensor, const Rotor& rotor,
                                      MassPointMaker& maker, StepData<Plane>& data) {
  std::vector<std::size_t> places;
  if (!needs_reading(sensor.quantity)) return places;
  const auto [first, end] = subsystems_of(sensor, data.subsystems.size());
  for (std::size_t i = first; i < end; ++i) {
    SubsystemData<Plane>& subsystem = data.subsystems[i];
    Reading<Plane> reading = make_reading(sensor, rotor.blades[i], subsystem);
    reading.masses = find_masses(reading, subsystem, maker);
    subsystem.readings.push_back(std::move(reading));
    places.push_back(subsystem.reading_count);
    subsystem.reading_count += kTwist;
  }
  return places;
}

/// Returns the sum of the momentum of the hub, then of the subsystems in their order.
double calc_total_momentum(const SensorColumn& column, const Hub& hub, std::int64_t step,
                           const StepData<Plane>& data) {
  const SystemRecord<Plane>& record = of_step(data.records, step);
  const Twist &x = record.position, &v = record.velocity;
  double sum = column.component == kRotation
                   ? hub.inertia * v[kRotation] + hub.mass * (x[0] * v[1] - x[1] * v[0])
                   : hub.mass * v[static_cast<Eigen::Index>(column.component)];
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    sum += readings_of(data.subsystems[i], step)[column.places[i] + column.component];
  return sum;
}

double calc_hub_reaction(const SensorColumn& column, const SystemRecord<Plane>& record) {
  Twist wrench = record.reaction;
  wrench[kRotation] += record.applied_torque;
  if (column.frame == SensorFrame::inertial)
    wrench = plane::Rotation::from_angle(record.position[kRotation]) * wrench;
  return wrench[static_cast<Eigen::Index>(column.component)];
}

}  // namespace

void add_columns(const Sensor& sensor, std::size_t subsystem,
                 std::span<const SensorComponent> components,
                 const std::vector<std::size_t>& places, std::vector<SensorColumn>& columns) {
  const std::string prefix = prefix_of(sensor, static_cast<int>(subsystem));
  std::size_t number = 0;
  for (const SensorComponent& component : components) {
    std::string name = prefix;
    if (!component.name.empty()) name += '.' + std::string(component.name);
    columns.push_back({std::move(name), std::string(component.unit), sensor.quantity,
                       frame_of(sensor), number++, subsystem, places});
  }
}

std::size_t count_readings(std::span<const Sensor> sensors, std::size_t subsystems) {
  std::size_t count = 0;
  for (const Sensor& sensor : sensors) {
    const auto [first, end] = subsystems_of(sensor, subsystems);
    if (needs_reading(sensor.quantity)) count += kTwist * (end - first);
  }
  return count;
}

std::vector<SensorColumn> place_sensors(std::span<const Sensor> sensors, const Rotor& rotor,
                                        StepData<Plane>& data) {
  assert(data.subsystems.size() == rotor.blades.size() && "allocated");
  std::vector<SensorColumn> columns;
  MassPointMaker maker;
  for (const Sensor& sensor : sensors) {
    const std::vector<std::size_t> places = add_readings(sensor, rotor, maker, data);
    const auto components = components_of(sensor.quantity);
    if (!is_of_blade(sensor.quantity)) {
      add_columns(sensor, 0, components, places, columns);
      continue;
    }
    const auto [first, end] = subsystems_of(sensor, data.subsystems.size());
    for (std::size_t i = first; i < end; ++i)
      add_columns(sensor, i, components,
                  places.empty() ? places : std::vector<std::size_t>{places[i - first]}, columns);
  }
  for (SubsystemData<Plane>& subsystem : data.subsystems) place_reading_ring(subsystem);
  return columns;
}

std::size_t count_mass_bytes(const StepData<Plane>& data) {
  std::set<const void*> counted;
  std::size_t bytes = 0;
  for (const SubsystemData<Plane>& subsystem : data.subsystems)
    for (const Reading<Plane>& reading : subsystem.readings)
      for (const MassPoints& points : reading.masses) {
        bytes += sizeof(MassPoints);
        if (counted.insert(points.get()).second) bytes += points->size() * sizeof(MassPoint);
      }
  return bytes;
}

double value_of(const SensorColumn& column, const Hub& hub, std::int64_t step,
                const StepData<Plane>& data) {
  switch (column.quantity) {  // a hub alone has momentum, but no subsystem
    case SensorQuantity::momentum:
      return calc_total_momentum(column, hub, step, data);
    case SensorQuantity::hub_reaction:
      return calc_hub_reaction(column, of_step(data.records, step));
    default:
      break;
  }
  const SubsystemData<Plane>& subsystem = data.subsystems[column.subsystem];
  if (const double* value = find_sampled(column.quantity, of_step(subsystem.samples, step)))
    return *value;
  const double value = readings_of(subsystem, step)[column.places[0] + column.component];
  const bool turns_with_hub = column.quantity == SensorQuantity::displacement &&
                              column.frame == SensorFrame::inertial &&
                              column.component == kRotation;
  return turns_with_hub ? value + of_step(data.records, step).position[kRotation] : value;
}

}  // namespace spoke
