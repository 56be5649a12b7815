// Finds bodies, sections and the parts outboard of them, and reads values from the table.

#include "engine/bodies/columns/spatial_columns.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <memory>
#include <utility>
#include <variant>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/marker_motion.h"
#include "engine/bodies/table/body_kind.h"
#include "models/solid_body.h"
#include "models/tree/sensor_place.h"

namespace spoke {
namespace {

using spatial::SensorPlace;
using spatial::Tree;

/// Returns the subsystems on which a sensor reads; all of them for a sensor of the whole system.
/// Quantities that are in the table anyway need no reading.
std::vector<SensorPlace> find_reading_places(const Sensor& sensor, std::size_t blades,
                                             const std::vector<Tree>& trees) {
  std::vector<SensorPlace> places;
  if (!needs_reading(sensor.quantity)) return places;
  if (is_of_blade(sensor.quantity)) return find_places(sensor, blades, trees);
  for (std::size_t i = 0; i < trees.size(); ++i) places.push_back({i, {0}});
  return places;
}

std::vector<int> path_to(int body, const Subsystem<Space>& subsystem) {
  std::vector<int> path;
  for (int j = body; j >= 0; j = subsystem.bodies[static_cast<std::size_t>(j)].parent)
    path.push_back(j);
  std::reverse(path.begin(), path.end());
  return path;
}

/// The maps of a sensor's nodes, by solid.
using Recoveries =
    std::map<const space::SolidConstants*, std::shared_ptr<const space::NodeRecovery>>;

int body_of(const Sensor& sensor, const SensorPlace& place, const Tree& tree) {
  if (sensor.joint) return place.bodies[static_cast<std::size_t>(sensor.joint->body())];
  const int first = place.bodies.front();
  if (!has_position(sensor.quantity)) return first;
  const auto* part =
      std::get_if<spatial::FlexibleBody>(&tree.bodies[static_cast<std::size_t>(first)].shape);
  if (!part) return first;
  return place.body_at(tree, sensor.position.value_or(tree.beams[part->beam].length));
}

/// Returns the index of the node of a solid that a sensor names.
int node_of(const Sensor& sensor, const spatial::SolidPart& part) {
  return find_node(*part.geometry().mesh, *sensor.node).value();
}

/// Returns the place on a solid that a sensor names, or its node.
space::Section find_solid_section(const Sensor& sensor, const spatial::SolidPart& part,
                                  const space::Body& body) {
  const BodyView<Space>& view = kind_of(body);
  if (sensor.node) return view.section_at_node(body, node_of(sensor, part));
  return view.section_at_place(
      body, static_cast<int>(find_interface(part.body(), sensor.interface).value()));
}

/// Makes the maps of the nodes of which a sensor shows the largest stress.
std::shared_ptr<const space::NodeRecovery> make_recovery(const Sensor& sensor,
                                                         const spatial::SolidPart& part,
                                                         const space::SolidConstants& solid) {
  if (sensor.node)
    return std::make_shared<space::NodeRecovery>(solid, std::vector{node_of(sensor, part)});
  if (sensor.interface.empty()) return std::make_shared<space::NodeRecovery>(solid);
  const std::size_t interface = find_interface(part.body(), sensor.interface).value();
  return std::make_shared<space::NodeRecovery>(solid, part.geometry().interfaces[interface].nodes);
}

/// Sets what a reading on a solid needs. `before`: readings of the same sensor on other subsystems.
void place_on_solid(const Sensor& sensor, const spatial::SolidPart& part, const space::Body& body,
                    Recoveries& before, Reading<Space>& reading) {
  if (sensor.quantity != SensorQuantity::von_mises) {
    reading.section = find_solid_section(sensor, part, body);
    return;
  }
  const std::shared_ptr<const space::SolidConstants> constants = kind_of(body).mesh(body);
  auto& recovery = before[constants.get()];
  if (!recovery) recovery = make_recovery(sensor, part, *constants);
  reading.recovery = recovery;
}

/// Returns the place of a position among the stations of a blade in air: an index, and a share of
/// the way to the next; without a position, the last one.
double find_in_air(const std::optional<double>& position, const std::vector<double>& stations) {
  const auto last = static_cast<double>(stations.size() - 1);
  if (!position) return last;
  const auto next = std::upper_bound(stations.begin(), stations.end(), *position);
  if (next == stations.begin()) return 0.0;
  if (next == stations.end()) return last;
  return static_cast<double>(next - stations.begin() - 1) +
         (*position - next[-1]) / (next[0] - next[-1]);
}

/// Returns the index of a coupling, which is there.
std::size_t find_coupling(const std::vector<LoopModel>& loops, const std::string& name) {
  const auto at = std::find_if(loops.begin(), loops.end(), [&name](const LoopModel& loop) {
    return loop.is_coupling() && loop.name == name;
  });
  assert(at != loops.end());
  return static_cast<std::size_t>(at - loops.begin());
}

Reading<Space> make_reading(const Sensor& sensor, const SensorPlace& place, const Tree& tree,
                            const Subsystem<Space>& subsystem, std::size_t first,
                            Recoveries& before) {
  Reading<Space> reading;
  reading.quantity = sensor.quantity;
  reading.frame = frame_of(sensor);
  reading.first = first;
  int body = body_of(sensor, place, tree);
  if (is_of_loop(sensor.quantity)) {
    reading.loop = find_loop(subsystem.loops, sensor.loop);
    body = subsystem.loops[reading.loop].from.body;
  }
  if (sensor.quantity == SensorQuantity::coupling_force)
    reading.loop = find_coupling(subsystem.loops, sensor.coupling);
  reading.path = path_to(body, subsystem);
  const TreeBody<Space>& model = subsystem.bodies[static_cast<std::size_t>(body)];
  const bool has_place = has_position(sensor.quantity);
  const auto* part =
      std::get_if<spatial::SolidPart>(&tree.bodies[static_cast<std::size_t>(body)].shape);
  if (part && (has_place || is_of_solid(sensor.quantity)))
    place_on_solid(sensor, *part, *model.body, before, reading);
  else if (has_place)
    kind_of(*model.body).place_reading(sensor.position, model, reading);
  if (!has_place) return reading;
  const space::Pose rest = calc_rest_pose(subsystem, body);
  reading.rest = {rest.p + rest.R * reading.section.s0, rest.R * reading.section.axes};
  if (sensor.quantity == SensorQuantity::section_force)
    kind_of(*model.body).find_outboard(model, reading);
  if (is_of_air(sensor.quantity))
    reading.along = find_in_air(sensor.position, subsystem.air->aerodynamics.station);
  return reading;
}

/// Returns the momentum of the hub, and its moment about the inertial origin.
space::Twist calc_hub_momentum(const space::Hub& hub, const SystemRecord<Space>& record) {
  return translate(space::Position(linear(record.position)),
                   record.hub_rotation * (hub.inertia * calc_recorded_twist(record)));
}

double calc_total_momentum(const SensorColumn& column, const space::Hub& hub, std::int64_t step,
                           const StepData<Space>& data) {
  const auto c = static_cast<Eigen::Index>(column.component);
  double sum = calc_hub_momentum(hub, of_step(data.records, step))[c];
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    sum += readings_of(data.subsystems[i], step)[column.places[i] + column.component];
  return sum;
}

/// Returns what support and drive do to the hub; on a support the axle and the drive.
double calc_hub_reaction(const SensorColumn& column, std::int64_t step,
                         const StepData<Space>& data) {
  const auto read = [&column](const auto& record, const space::Rotation& R) {
    space::Twist wrench = record.reaction;
    wrench[Space::kAxial] += record.applied_torque;
    if (column.frame == SensorFrame::inertial) wrench = R * wrench;
    return wrench[static_cast<Eigen::Index>(column.component)];
  };
  const SystemRecord<Space>& base = of_step(data.records, step);
  if (data.rotors.empty()) return read(base, base.hub_rotation);
  const RotorRecord<Space>& rotor = of_step(data.rotors.front().records, step);
  return read(rotor, rotor.rotation);
}

}  // namespace

std::size_t count_readings(std::span<const Sensor> sensors, std::size_t blades,
                           const std::vector<Tree>& trees) {
  std::size_t count = 0;
  for (const Sensor& sensor : sensors)
    count += space::kTwist * find_reading_places(sensor, blades, trees).size();
  return count;
}

std::vector<SensorColumn> place_sensors(std::span<const Sensor> sensors, std::size_t blades,
                                        const std::vector<Tree>& trees, const System<Space>& system,
                                        StepData<Space>& data) {
  assert(data.subsystems.size() == trees.size() && blades <= trees.size() && "allocated");
  std::vector<SensorColumn> columns;
  for (const Sensor& sensor : sensors) {
    std::vector<std::size_t> places;
    Recoveries recoveries;
    for (const SensorPlace& place : find_reading_places(sensor, blades, trees)) {
      SubsystemData<Space>& subsystem = data.subsystems[place.tree];
      subsystem.readings.push_back(make_reading(sensor, place, trees[place.tree],
                                                system.subsystems[place.tree],
                                                subsystem.reading_count, recoveries));
      places.push_back(
          std::exchange(subsystem.reading_count, subsystem.reading_count + space::kTwist));
    }
    const auto components = components_in_space(sensor.quantity);
    if (!is_of_blade(sensor.quantity)) {
      add_columns(sensor, 0, components, places, columns);
      continue;
    }
    std::size_t number = 0;
    for (const SensorPlace& place : find_places(sensor, blades, trees)) {
      const auto own = places.empty() ? places : std::vector<std::size_t>{places[number++]};
      add_columns(sensor, place.tree, components, own, columns);
    }
  }
  return columns;
}

void make_reading_rings(StepData<Space>& data) {
  for (SubsystemData<Space>& subsystem : data.subsystems) place_reading_ring(subsystem);
}

std::size_t count_reading_bytes(const StepData<Space>& data) {
  std::size_t bytes = 0;
  for (const SubsystemData<Space>& subsystem : data.subsystems)
    for (const Reading<Space>& reading : subsystem.readings) {
      bytes += sizeof reading;
      if (reading.recovery) bytes += reading.recovery->bytes();
      for (const OutboardLoad& load : reading.loads)
        bytes += load.sections.size() * (sizeof(space::Section) + sizeof(BodyLoad<Space>::Point));
    }
  return bytes;
}

double value_of(const SensorColumn& column, const space::Hub& hub, std::int64_t step,
                const StepData<Space>& data) {
  switch (column.quantity) {  // a hub alone has momentum, but no subsystem
    case SensorQuantity::momentum:
      return calc_total_momentum(column, hub, step, data);
    case SensorQuantity::hub_reaction:
      return calc_hub_reaction(column, step, data);
    default:
      break;
  }
  const SubsystemData<Space>& subsystem = data.subsystems[column.subsystem];
  if (const double* value = find_sampled(column.quantity, of_step(subsystem.samples, step)))
    return *value;
  return readings_of(subsystem, step)[column.places[0] + column.component];
}

}  // namespace spoke
