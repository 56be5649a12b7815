// Checks which keys belong to which sensor in space, and that no two columns have one name.

#include "models/reader/spatial/sensor_reader.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <variant>

#include "models/count_text.h"
#include "models/reader/blade_choice_reader.h"
#include "models/reader/names.h"
#include "models/reader/row_reader.h"
#include "models/reader/sensor_keys.h"
#include "models/reader/spatial/body_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/solid_faults.h"
#include "models/support/nearest_name.h"
#include "models/tree/sensor_place.h"
#include "spoke/error.h"

namespace spoke::spatial {
namespace {

/// Whether a sensor is on a body, or at a joint.
bool needs_body(const Sensor& sensor) {
  return has_position(sensor.quantity) || sensor.quantity == SensorQuantity::joint_reaction ||
         is_of_solid(sensor.quantity);
}

Fault find_blade_fault(const Sensor& sensor, const Model& model) {
  if (!sensor.body.empty()) return {"body", "would be ignored, expected only along with subsystem"};
  if (is_of_solid(sensor.quantity))
    return {"", "is on blades, of which none is a solid; expected subsystem and body"};
  const auto last = static_cast<int>(model.blades.size());
  if (is_of_blade(sensor.quantity) && last == 0)
    return {"", "is on blades, of which there are none; expected subsystem and body"};
  if (is_of_air(sensor.quantity))
    for (std::size_t i = 0; i < model.blades.size(); ++i)
      if (sensor.blade.holds(i) && !(model.air && model.blades[i].aerodynamics))
        return {"quantity", "is \"" + std::string(name_of(sensor.quantity)) +
                                "\", but no air acts on blade " + std::to_string(i + 1) +
                                ", expected [air] and its aerodynamics"};
  const int number = sensor.blade.number();
  if (sensor.blade.is_all() || (number >= 1 && number <= last)) return {};
  return {"blade", "is " + std::to_string(number) + ", expected a whole number from 1 to " +
                       std::to_string(last)};
}

/// Finds a fault in the subsystem and body that a sensor names.
Fault find_body_fault(const Sensor& sensor, const Model& model) {
  if (!is_of_blade(sensor.quantity) || is_of_air(sensor.quantity))
    return {"subsystem", "does not belong to quantity \"" + std::string(name_of(sensor.quantity)) +
                             "\", expected none"};
  if (!sensor.blade.is_all()) return {"blade", "given along with subsystem, expected only one"};
  std::vector<std::string_view> names, bodies;
  const Subsystem* found = nullptr;
  for (const Subsystem& subsystem : model.subsystems) {
    names.push_back(subsystem.name);
    if (subsystem.name == sensor.subsystem) found = &subsystem;
  }
  if (names.empty())
    return {"subsystem", "is \"" + sensor.subsystem + "\", but there is no [[subsystem]]"};
  if (!found) return {"subsystem", describe_unknown(sensor.subsystem, names)};
  if (!needs_body(sensor)) {
    if (sensor.body.empty()) return {};
    return {"body", "does not belong to quantity \"" + std::string(name_of(sensor.quantity)) +
                        "\", expected the subsystem alone"};
  }
  for (const Body& body : found->bodies) bodies.push_back(body.name);
  std::vector<std::string> of_rotors;  // outlive their views
  for (const int r : find_rotors_on(model, sensor.subsystem)) {
    of_rotors.push_back(prefix_of_rotor(model, r) + "hub");
    if (axle_of(model, r).train)
      of_rotors.push_back(prefix_of_rotor(model, r) + std::string(kGeneratorName));
  }
  bodies.insert(bodies.end(), of_rotors.begin(), of_rotors.end());
  if (sensor.body.empty()) return {"body", "is missing, expected the name of one of the subsystem"};
  if (std::find(bodies.begin(), bodies.end(), sensor.body) == bodies.end())
    return {"body", describe_unknown(sensor.body, bodies)};
  return {};
}

/// Returns the least length of the beams that a sensor is on; 0 on a rigid body.
double length_at(const std::vector<SensorPlace>& places, const std::vector<Tree>& trees) {
  double least = std::numeric_limits<double>::infinity();
  for (const SensorPlace& place : places) {
    const Tree& tree = trees[place.tree];
    const auto* part = std::get_if<FlexibleBody>(
        &tree.bodies[static_cast<std::size_t>(place.bodies.front())].shape);
    least = std::min(least, part ? tree.beams[part->beam].length : 0.0);
  }
  return least;
}

/// Returns the solid that a sensor is on; null if it is on none.
const SolidPart* find_solid(const std::vector<SensorPlace>& places,
                            const std::vector<Tree>& trees) {
  if (places.empty()) return nullptr;
  const SensorPlace& first = places.front();
  const std::size_t body = static_cast<std::size_t>(first.bodies.front());
  return std::get_if<SolidPart>(&trees[first.tree].bodies[body].shape);
}

/// Finds what belongs to solids on other bodies.
Fault find_solid_keys(const Sensor& sensor) {
  const std::string quantity(name_of(sensor.quantity));
  if (is_of_solid(sensor.quantity))
    return {"body", "is no solid, which quantity \"" + quantity + "\" belongs to"};
  const std::string expected = "belongs to solids, expected position on a beam";
  if (!sensor.interface.empty()) return {"interface", expected};
  if (sensor.node) return {"node", expected};
  return {};
}

/// Finds a fault of the place on a solid.
Fault find_solid_fault(const Sensor& sensor, const SolidPart& solid) {
  const SensorQuantity quantity = sensor.quantity;
  if (quantity == SensorQuantity::section_force)
    return {"body", "is a solid, expected a beam; \"interface_force\" is the force on a solid"};
  if (sensor.position)
    return {"position", "belongs to beams, expected interface or node on a solid"};
  if (sensor.node && !sensor.interface.empty())
    return {"node", "given along with interface, expected only one of them"};
  if (sensor.node && quantity == SensorQuantity::interface_force)
    return {"node", "does not belong to quantity \"interface_force\", expected interface"};
  if (sensor.node && !find_node(*solid.geometry().mesh, *sensor.node))
    return {"node", "is " + std::to_string(*sensor.node) + ", expected the number of one of the " +
                        counted(std::ssize(solid.geometry().mesh->nodes), "node") + " of the mesh"};
  if (quantity == SensorQuantity::von_mises) {
    if (solid.body().matrices)
      return {"quantity", "is \"von_mises\", but matrices do not tell the stresses"};
    if (sensor.interface.empty()) return {};
  }
  if (sensor.node) return {};
  if (sensor.interface.empty() && quantity == SensorQuantity::interface_force)
    return {"interface", "is missing, expected the name of an interface"};
  return find_interface_fault(sensor.interface, solid.body());
}

Fault find_position_fault(const Sensor& sensor, double length) {
  const bool is_force = sensor.quantity == SensorQuantity::section_force;
  if (length == 0.0 && is_force) return {"body", "is rigid, expected a beam"};
  if (length == 0.0 && sensor.position)
    return {"position", "belongs to beams; of a rigid body it is the origin of its frame"};
  if (!sensor.position)
    return is_force ? Fault{"position", "is missing, expected a distance from the root (m)"}
                    : Fault{};
  const FirstFault first;
  first("position", *sensor.position, {"m, from root to tip", 0.0, length});
  return first.found();
}

Fault find_joint_fault(const Sensor& sensor, const std::vector<SensorPlace>& places) {
  if (!sensor.subsystem.empty()) {
    if (!sensor.joint) return {};
    return {"joint", "belongs to blades; of a body it is the one that carries it"};
  }
  std::size_t most = std::numeric_limits<int>::max();
  for (const SensorPlace& place : places) most = std::min(most, place.bodies.size());
  const std::string expected = "expected a whole number from 1 to " + std::to_string(most);
  if (!sensor.joint) return {"joint", "is missing, " + expected};
  const int number = sensor.joint->number();
  if (number >= 1 && static_cast<std::size_t>(number) <= most) return {};
  return {"joint", "is " + std::to_string(number) + ", " + expected};
}

/// Returns the loops of each blade, or of the subsystem, that a sensor is on.
std::vector<const std::vector<Loop>*> loops_of(const Sensor& sensor, const Model& model) {
  std::vector<const std::vector<Loop>*> loops;
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    if (sensor.subsystem.empty() && sensor.blade.holds(i)) loops.push_back(&model.blades[i].loops);
  for (const Subsystem& subsystem : model.subsystems)
    if (subsystem.name == sensor.subsystem) loops.push_back(&subsystem.loops);
  return loops;
}

/// Finds a fault of the coupling that a sensor names: of each blade, or of the subsystem, it is on.
Fault find_coupling_fault(const Sensor& sensor, const Model& model) {
  if (sensor.quantity != SensorQuantity::coupling_force) return {};
  if (sensor.coupling.empty()) return {"coupling", "is missing, expected the name of a coupling"};
  const auto find_missing = [&sensor](const std::vector<Coupling>& couplings) -> Fault {
    if (couplings.empty())
      return {"coupling", "is \"" + sensor.coupling + "\", but there is no coupling"};
    std::vector<std::string_view> names;
    for (const Coupling& coupling : couplings) names.push_back(coupling.name);
    if (std::find(names.begin(), names.end(), sensor.coupling) != names.end()) return {};
    return {"coupling", describe_unknown(sensor.coupling, names)};
  };
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    if (sensor.subsystem.empty() && sensor.blade.holds(i))
      if (Fault fault = find_missing(model.blades[i].couplings)) return fault;
  for (const Subsystem& subsystem : model.subsystems)
    if (subsystem.name == sensor.subsystem)
      if (Fault fault = find_missing(subsystem.couplings)) return fault;
  return {};
}

Fault find_fault(const Sensor& sensor, const Model& model, const std::vector<Tree>& trees) {
  if (!sensor.name.empty() && !is_name(sensor.name))
    return {"name", "is \"" + sensor.name + "\", expected " + kNameExpected};
  if (const std::string fault = find_frame_fault(sensor); !fault.empty()) return {"frame", fault};
  if (sensor.quantity == SensorQuantity::wind && !model.air)
    return {"quantity", "is \"wind\", but there is no air, expected [air]"};
  if (Fault fault = sensor.subsystem.empty() ? find_blade_fault(sensor, model)
                                             : find_body_fault(sensor, model))
    return fault;
  if (const std::string fault = find_loop_fault(sensor, loops_of(sensor, model)); !fault.empty())
    return {"loop", fault};
  if (Fault fault = find_coupling_fault(sensor, model)) return fault;
  if (!needs_body(sensor)) return {};
  const auto places = find_places(sensor, model.blades.size(), trees);
  if (const SolidPart* solid = find_solid(places, trees)) {
    if (sensor.quantity != SensorQuantity::joint_reaction) return find_solid_fault(sensor, *solid);
  } else if (Fault fault = find_solid_keys(sensor)) {
    return fault;
  }
  if (has_position(sensor.quantity)) return find_position_fault(sensor, length_at(places, trees));
  return find_joint_fault(sensor, places);
}

/// Returns the names of the columns that every simulation of the model has.
std::set<std::string> find_taken(const std::vector<Tree>& trees) {
  std::set<std::string> taken;
  for (const char* axis : {"x", "y", "z"})
    for (const char* name : {"hub.", "hub.rotation.", "hub.spin."})
      taken.insert(std::string(name) + axis);
  for (const Tree& tree : trees) {
    const std::string name = sensor_name_of(tree);
    for (const char* axis : {"x", "y", "z"})
      for (const char* shown : {".tip.", ".root.force.", ".root.moment."})
        taken.insert(name + shown + axis);
    for (std::string& joint : joint_columns_of(tree)) taken.insert(std::move(joint));
  }
  return taken;
}

/// Applies the rules to one sensor after the other.
class SensorRules {
 public:
  explicit SensorRules(const Model& model)
      : model_(model),
        trees_(build_trees(model)),
        columns_([taken = find_taken(trees_)](const std::string& name) {
          return taken.count(name) > 0;
        }) {}

  Fault find_next_fault(const Sensor& sensor) {
    if (Fault fault = find_fault(sensor, model_, trees_)) return fault;
    std::vector<std::string> names;
    const auto components = components_in_space(sensor.quantity);
    if (is_of_blade(sensor.quantity))
      for (const SensorPlace& place : find_places(sensor, model_.blades.size(), trees_))
        append_columns(sensor, static_cast<int>(place.tree), components, names);
    else
      append_columns(sensor, 0, components, names);
    const std::string fault = columns_.add(names);
    return fault.empty() ? Fault{} : Fault{"name", fault};
  }

 private:
  const Model& model_;
  std::vector<Tree> trees_;
  ColumnNames columns_;
};

constexpr Count kNodes{1, std::numeric_limits<int>::max()};

Sensor read_sensor(const TomlSection& section, const Model& model) {
  Sensor sensor;
  sensor.quantity = read_quantity(section, false);
  require_fitting_keys(section, sensor.quantity, false);
  sensor.name = section.text("name", std::string(name_of(sensor.quantity)));
  sensor.frame = read_sensor_frame(section, sensor.quantity);
  sensor.subsystem = section.text("subsystem", "");
  sensor.body = section.text("body", "");
  if (section.has("blade") && section.has("subsystem"))
    section.fail("blade", "given along with subsystem, expected only one of them");
  if (!model.blades.empty()) sensor.blade = read_blade(section, model.blades.size());
  if (section.has("joint"))
    sensor.joint =
        JointChoice::number(section.integer("joint", {1, std::numeric_limits<int>::max()}));
  sensor.loop = section.text("loop", "");
  sensor.coupling = section.text("coupling", "");
  if (section.has("position")) sensor.position = section.number("position", kStation);
  sensor.interface = section.text("interface", "");
  if (section.has("node")) sensor.node = section.integer("node", kNodes);
  return sensor;
}

}  // namespace

std::vector<Sensor> read_sensors(const TomlSection& root, const Model& model) {
  std::vector<Sensor> sensors;
  const auto sections = root.sections("sensor", keys::keys_of(keys::kSpaceSensorRows));
  if (sections.empty()) return sensors;
  SensorRules rules(model);
  for (const TomlSection& section : sections) {
    Sensor sensor = read_sensor(section, model);
    for (const std::string& name : find_copies(root, sensor.subsystem)) {
      sensor.subsystem = name;
      if (const Fault fault = rules.find_next_fault(sensor))
        section.fail_at(fault.path == "name" && !section.has("name") ? "" : fault.path, fault.text);
      sensors.push_back(sensor);
    }
  }
  return sensors;
}

void check_sensors(const std::vector<Sensor>& sensors, const Model& model) {
  if (sensors.empty()) return;
  SensorRules rules(model);
  std::size_t number = 0;
  for (const Sensor& sensor : sensors) {
    const Fault fault = rules.find_next_fault(sensor).within("sensor." + std::to_string(++number));
    if (fault) throw InputError(fault.path + ": " + fault.text, {.key = fault.path});
  }
}

}  // namespace spoke::spatial
