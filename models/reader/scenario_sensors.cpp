// Reads and checks sensors: which keys belong to which quantity, and that no two names are alike.

#include "models/reader/scenario_sensors.h"

#include <algorithm>

#include "models/reader/blade_choice_reader.h"
#include "models/reader/names.h"
#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"
#include "models/reader/sensor_keys.h"
#include "spoke/error.h"

namespace spoke {
namespace {

/// Returns the least value of a property among the blades that a sensor is on.
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

/// Whether a column is one that every simulation has, such as "blade1.tip.x".
bool is_default(const std::string& name) {
  if (!name.starts_with("blade")) return false;
  const std::string rest = name.substr(std::min(name.find('.'), name.size()));
  constexpr std::string_view shown[] = {".tip.x",  ".tip.y",  ".tip.along",  ".tip.across",
                                        ".root.x", ".root.y", ".root.moment"};
  return std::find(std::begin(shown), std::end(shown), rest) != std::end(shown);
}

std::vector<std::string> columns_of(const Sensor& sensor, std::size_t blades) {
  const bool is_everywhere = is_of_blade(sensor.quantity) && sensor.blade.is_all();
  const int first = sensor.blade.is_all() ? 0 : sensor.blade.number() - 1;
  const int end = is_everywhere ? static_cast<int>(blades) : first + 1;
  std::vector<std::string> names;
  for (int blade = first; blade < end; ++blade)
    append_columns(sensor, blade, components_of(sensor.quantity), names);
  return names;
}

/// Returns the loops of each blade that a sensor is on.
std::vector<const std::vector<Loop>*> loops_of(const Sensor& sensor,
                                               const std::vector<Blade>& blades) {
  std::vector<const std::vector<Loop>*> loops;
  for (std::size_t i = 0; i < blades.size(); ++i)
    if (sensor.blade.holds(i)) loops.push_back(&blades[i].loops);
  return loops;
}

Sensor read_sensor(const TomlSection& section, const std::vector<Blade>& blades) {
  Sensor sensor;
  sensor.quantity = read_quantity(section, true);
  const SensorQuantity quantity = sensor.quantity;
  require_fitting_keys(section, quantity, true);
  sensor.name = section.text("name", std::string(name_of(quantity)));
  if (!is_name(sensor.name)) section.fail_expected("name", kNameExpected);
  if (is_of_blade(quantity) && blades.empty()) section.fail("", kNoBlades);
  sensor.blade = read_blade(section, blades.size());
  sensor.frame = read_sensor_frame(section, quantity);
  if (quantity == SensorQuantity::joint_reaction)
    sensor.joint = JointChoice::number(
        section.integer("joint", {1, least_of(sensor, blades, &Blade::bodies)}));
  sensor.loop = section.text("loop", "");
  if (const std::string fault = find_loop_fault(sensor, loops_of(sensor, blades)); !fault.empty())
    section.fail("loop", fault);
  if (quantity == SensorQuantity::section_force || section.has("position"))
    sensor.position = section.number("position", place_of(sensor, blades));
  return sensor;
}

[[noreturn]] void refuse_sensor(const std::string& key, const std::string& what) {
  throw InputError(key + ": " + what, {.key = key});
}

void check_sensor(const std::string& path, const Sensor& sensor, const std::vector<Blade>& blades) {
  if (is_of_solid(sensor.quantity))
    refuse_sensor(path + ".quantity", "is \"" + std::string(name_of(sensor.quantity)) +
                                          "\", which belongs to solids, in world = \"space\"");
  if (is_of_blade(sensor.quantity) && blades.empty()) refuse_sensor(path, kNoBlades);
  const auto last = static_cast<int>(blades.size());
  const int number = sensor.blade.number();
  if (!sensor.blade.is_all() && (number < 1 || number > last))
    refuse_sensor(path + ".blade", "is " + std::to_string(number) +
                                       ", expected a whole number from 1 to " +
                                       std::to_string(last));
  if (!sensor.name.empty() && !is_name(sensor.name))
    refuse_sensor(path + ".name", "is \"" + sensor.name + "\", expected " + kNameExpected);
  if (const std::string fault = find_frame_fault(sensor); !fault.empty())
    refuse_sensor(path + ".frame", fault);
  if (const std::string fault = find_loop_fault(sensor, loops_of(sensor, blades)); !fault.empty())
    refuse_sensor(path + ".loop", fault);
  if (sensor.quantity == SensorQuantity::joint_reaction) {
    const int joints = least_of(sensor, blades, &Blade::bodies);
    const std::string expected = "expected a whole number from 1 to " + std::to_string(joints);
    if (!sensor.joint) refuse_sensor(path + ".joint", "is missing, " + expected);
    if (const int joint = sensor.joint->number(); joint < 1 || joint > joints)
      refuse_sensor(path + ".joint", "is " + std::to_string(joint) + ", " + expected);
  }
  if (!sensor.position) return;
  const std::string expected = place_of(sensor, blades).expectation_instead_of(*sensor.position);
  if (!expected.empty())
    refuse_sensor(path + ".position",
                  "is " + describe(*sensor.position) + ", expected " + expected);
}

}  // namespace

std::vector<Sensor> read_sensors(const TomlSection& root, const std::vector<Blade>& blades) {
  std::vector<Sensor> sensors;
  ColumnNames columns(is_default);
  for (const TomlSection& section : root.sections("sensor", keys::keys_of(keys::kSensorRows))) {
    sensors.push_back(read_sensor(section, blades));
    const std::string fault = columns.add(columns_of(sensors.back(), blades.size()));
    if (!fault.empty()) section.fail(section.has("name") ? "name" : "", fault);
  }
  return sensors;
}

void check_sensors(const std::vector<Sensor>& sensors, const std::vector<Blade>& blades) {
  ColumnNames columns(is_default);
  std::size_t number = 0;
  for (const Sensor& sensor : sensors) {
    const std::string path = "sensor." + std::to_string(++number);
    check_sensor(path, sensor, blades);
    const std::string fault = columns.add(columns_of(sensor, blades.size()));
    if (!fault.empty()) refuse_sensor(path, fault);
  }
}

}  // namespace spoke
