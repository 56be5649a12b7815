// Reads and checks sensors: which keys belong to which quantity, and that no two names are alike.

#include "models/reader/scenario_sensors.h"

#include <algorithm>
#include <set>
#include <utility>

#include "models/reader/blade_choice_reader.h"
#include "models/reader/names.h"
#include "models/reader/scenario_fields.h"
#include "spoke/error.h"

namespace spoke {
namespace {

constexpr std::size_t kMostValues = 1'000'000;

constexpr std::initializer_list<SensorQuantity> kQuantities{
    SensorQuantity::displacement,  SensorQuantity::velocity,       SensorQuantity::acceleration,
    SensorQuantity::section_force, SensorQuantity::joint_reaction, SensorQuantity::hub_reaction,
    SensorQuantity::momentum,      SensorQuantity::blade_momentum, SensorQuantity::kinetic_energy};

/// The least of a property of the blades that a sensor is on.
template <class Value>
Value least_of(const Sensor& sensor, const std::vector<Blade>& blades, Value Blade::*member) {
  if (!sensor.blade.is_all())
    return blades[static_cast<std::size_t>(sensor.blade.number() - 1)].*member;
  Value least = blades.front().*member;
  for (const Blade& blade : blades) least = std::min(least, blade.*member);
  return least;
}

Quantity place_of(const Sensor& sensor, const std::vector<Blade>& blades) {
  return {"m, from root to tip of the blade", 0.0, least_of(sensor, blades, &Blade::length)};
}

/// Names of columns that are taken: those that every simulation has, and those of sensors.
class Columns {
 public:
  /// Those that every simulation has but for the blades'.
  Columns()
      : taken_{"hub.x",
               "hub.y",
               "hub.angle",
               "hub.speed",
               "hub.torque",
               "energy.kinetic",
               "energy.strain",
               "energy.work",
               "energy.dissipated",
               "energy.residual",
               "t"} {}

  /// Adds the columns of a sensor. What is wrong with them, or nothing.
  std::string add(const Sensor& sensor, std::size_t blades) {
    const bool is_everywhere = is_of_blade(sensor.quantity) && sensor.blade.is_all();
    const int first = sensor.blade.is_all() ? 0 : sensor.blade.number() - 1;
    const int end = is_everywhere ? static_cast<int>(blades) : first + 1;
    const auto components = components_of(sensor.quantity);
    count_ += static_cast<std::size_t>(end - first) * components.size();
    if (count_ > kMostValues)
      return "makes " + std::to_string(count_) + " values with those before it, expected at most " +
             std::to_string(kMostValues);
    for (int blade = first; blade < end; ++blade) {
      const std::string prefix = prefix_of(sensor, blade);
      for (const SensorComponent& component : components) {
        std::string name = prefix;
        if (!component.name.empty()) name += '.' + std::string(component.name);
        if (is_default(name) || !taken_.insert(name).second)
          return "there is a column " + name + " already, expected a name of its own";
      }
    }
    return {};
  }

 private:
  /// "blade1.tip.x" and the like.
  static bool is_default(const std::string& name) {
    if (!name.starts_with("blade")) return false;
    const std::string rest = name.substr(std::min(name.find('.'), name.size()));
    constexpr std::string_view shown[] = {".tip.x",  ".tip.y",  ".tip.along",  ".tip.across",
                                          ".root.x", ".root.y", ".root.moment"};
    return std::find(std::begin(shown), std::end(shown), rest) != std::end(shown);
  }

  std::set<std::string> taken_;
  std::size_t count_ = 0;
};

/// Refuses a key that would be ignored.
void require_fitting(const TomlSection& section, std::string_view key, bool fits,
                     SensorQuantity quantity) {
  if (fits || !section.has(key)) return;
  TomlSection::Keys fitting;
  for (const SensorQuantity other : kQuantities) {
    const bool takes = key == "position" ? has_position(other)
                       : key == "joint"  ? other == SensorQuantity::joint_reaction
                       : key == "frame"  ? frames_of(other).size() > 1
                                         : is_of_blade(other);
    if (takes) fitting.push_back(name_of(other));
  }
  section.fail(key, "does not belong to quantity \"" + std::string(name_of(quantity)) +
                        "\", expected only with quantity " + join_names(fitting));
}

SensorFrame read_frame(const TomlSection& section, SensorQuantity quantity) {
  const auto frames = frames_of(quantity);
  if (!section.has("frame")) return frames.front();
  TomlSection::Keys names;
  for (const SensorFrame frame : frames) names.push_back(name_of(frame));
  return frames[section.choice("frame", names)];
}

Sensor read_sensor(const TomlSection& section, const std::vector<Blade>& blades) {
  Sensor sensor;
  if (!section.has("quantity"))
    section.fail("quantity", "is missing, expected what is measured, as quantity = \"velocity\"");
  sensor.quantity = section.choice("quantity", kQuantities, sensor.quantity);
  const SensorQuantity quantity = sensor.quantity;
  const bool has_joint = quantity == SensorQuantity::joint_reaction;
  require_fitting(section, "blade", is_of_blade(quantity), quantity);
  require_fitting(section, "position", has_position(quantity), quantity);
  require_fitting(section, "joint", has_joint, quantity);
  require_fitting(section, "frame", frames_of(quantity).size() > 1, quantity);
  sensor.name = section.text("name", std::string(name_of(quantity)));
  if (!is_name(sensor.name)) section.fail_expected("name", kNameExpected);
  sensor.blade = read_blade(section, blades.size());
  sensor.frame = read_frame(section, quantity);
  if (has_joint)
    sensor.joint = JointChoice::number(
        section.integer("joint", {1, least_of(sensor, blades, &Blade::bodies)}));
  if (quantity == SensorQuantity::section_force || section.has("position"))
    sensor.position = section.number("position", place_of(sensor, blades));
  return sensor;
}

[[noreturn]] void fail(const std::string& key, const std::string& what) {
  throw InputError(key + ": " + what);
}

void check_sensor(const std::string& path, const Sensor& sensor, const std::vector<Blade>& blades) {
  const auto last = static_cast<int>(blades.size());
  const int number = sensor.blade.number();
  if (!sensor.blade.is_all() && (number < 1 || number > last))
    fail(path + ".blade", "is " + std::to_string(number) + ", expected a whole number from 1 to " +
                              std::to_string(last));
  if (!sensor.name.empty() && !is_name(sensor.name))
    fail(path + ".name", "is \"" + sensor.name + "\", expected " + kNameExpected);
  const auto frames = frames_of(sensor.quantity);
  if (std::find(frames.begin(), frames.end(), frame_of(sensor)) == frames.end())
    fail(path + ".frame", "is \"" + std::string(name_of(frame_of(sensor))) +
                              "\", which does not belong to quantity \"" +
                              std::string(name_of(sensor.quantity)) + "\"");
  if (sensor.quantity == SensorQuantity::joint_reaction) {
    const int joints = least_of(sensor, blades, &Blade::bodies);
    const std::string expected = "expected a whole number from 1 to " + std::to_string(joints);
    if (!sensor.joint) fail(path + ".joint", "is missing, " + expected);
    if (const int joint = sensor.joint->number(); joint < 1 || joint > joints)
      fail(path + ".joint", "is " + std::to_string(joint) + ", " + expected);
  }
  if (!sensor.position) return;
  const std::string expected = place_of(sensor, blades).expectation_instead_of(*sensor.position);
  if (!expected.empty())
    fail(path + ".position", "is " + describe(*sensor.position) + ", expected " + expected);
}

}  // namespace

std::vector<Sensor> read_sensors(const TomlSection& root, const std::vector<Blade>& blades) {
  std::vector<Sensor> sensors;
  Columns columns;
  for (const TomlSection& section :
       root.sections("sensor", {"name", "quantity", "blade", "position", "joint", "frame"})) {
    sensors.push_back(read_sensor(section, blades));
    const std::string fault = columns.add(sensors.back(), blades.size());
    if (!fault.empty()) section.fail(section.has("name") ? "name" : "", fault);
  }
  return sensors;
}

void check_sensors(const std::vector<Sensor>& sensors, const std::vector<Blade>& blades) {
  Columns columns;
  std::size_t number = 0;
  for (const Sensor& sensor : sensors) {
    const std::string path = "sensor." + std::to_string(++number);
    check_sensor(path, sensor, blades);
    const std::string fault = columns.add(sensor, blades.size());
    if (!fault.empty()) fail(path, fault);
  }
}

}  // namespace spoke
