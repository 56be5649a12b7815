// Quantities and frames by their names, and checks that no two columns have one name.

#include "models/reader/sensor_keys.h"

#include <algorithm>
#include <utility>

#include "models/reader/keys/simulation_keys.h"
#include "models/reader/row_reader.h"
#include "models/sensor_quantities.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

constexpr std::size_t kMostValues = 1'000'000;

/// Whether a sensor of this quantity has a use for a key.
bool takes(const QuantityRow& row, std::string_view key) {
  const MeasuredAt at = row.at;
  if (key == "position") return has_position(row.quantity);
  if (key == "joint") return at == MeasuredAt::joint;
  if (key == "loop") return at == MeasuredAt::loop;
  if (key == "coupling") return at == MeasuredAt::coupling;
  if (key == "interface") return at == MeasuredAt::place || is_of_solid(row.quantity);
  if (key == "node") return at == MeasuredAt::place || at == MeasuredAt::solid;
  if (key == "frame") return row.frames.size() > 1;
  return is_of_blade(row.quantity) && !is_of_solid(row.quantity);
}

/// Refuses a key that would be ignored.
void require_fitting(const TomlSection& section, std::string_view key, SensorQuantity quantity,
                     bool in_plane) {
  if (takes(row_of(quantity), key) || !section.has(key)) return;
  TomlSection::Keys fitting;
  for (const QuantityRow& other : quantities::kRows)
    if (takes(other, key) && quantities::is_known(other, in_plane)) fitting.push_back(other.name);
  section.fail(key, "does not belong to quantity \"" + std::string(name_of(quantity)) +
                        "\", expected only with quantity " + join_names(fitting));
}

}  // namespace

SensorQuantity read_quantity(const TomlSection& section, bool in_plane) {
  if (!section.has("quantity"))
    section.fail("quantity", "is missing, expected what is measured, as quantity = \"velocity\"");
  const keys::Rows rows = in_plane ? keys::Rows(keys::kSensorRows) : keys::kSpaceSensorRows;
  std::vector<SensorQuantity> known;  // in the order of the words
  for (const QuantityRow& row : quantities::kRows)
    if (quantities::is_known(row, in_plane)) known.push_back(row.quantity);
  return known[keys::read_word(section, rows, "quantity")];
}

SensorFrame read_sensor_frame(const TomlSection& section, SensorQuantity quantity) {
  const auto frames = frames_of(quantity);
  if (!section.has("frame")) return frames.front();
  TomlSection::Keys names;
  for (const SensorFrame frame : frames) names.push_back(name_of(frame));
  return frames[section.choice("frame", names)];
}

void require_fitting_keys(const TomlSection& section, SensorQuantity quantity, bool in_plane) {
  for (const std::string_view key :
       {"blade", "position", "joint", "loop", "coupling", "interface", "node", "frame"})
    require_fitting(section, key, quantity, in_plane);
}

std::string find_frame_fault(const Sensor& sensor) {
  const auto frames = frames_of(sensor.quantity);
  if (std::find(frames.begin(), frames.end(), frame_of(sensor)) != frames.end()) return {};
  return "is \"" + std::string(name_of(frame_of(sensor))) +
         "\", which does not belong to quantity \"" + std::string(name_of(sensor.quantity)) + "\"";
}

std::string find_loop_fault(const Sensor& sensor,
                            const std::vector<const std::vector<Loop>*>& loops) {
  if (!is_of_loop(sensor.quantity)) {
    return sensor.loop.empty() ? ""
                               : "does not belong to quantity \"" +
                                     std::string(name_of(sensor.quantity)) + "\", expected none";
  }
  for (const std::vector<Loop>* own : loops) {
    std::vector<std::string_view> names;
    for (const Loop& loop : *own) names.push_back(loop.name);
    if (names.empty())
      return (sensor.loop.empty() ? "is missing" : "is \"" + sensor.loop + '"') +
             ", but the sensor is where there is no [[" +
             (sensor.subsystem.empty() ? "blade" : "subsystem") + ".loop]]";
    if (sensor.loop.empty()) return "is missing, expected the name of a loop";
    if (std::find(names.begin(), names.end(), sensor.loop) == names.end())
      return describe_unknown(sensor.loop, names);
  }
  return {};
}

void append_columns(const Sensor& sensor, int blade, std::span<const SensorComponent> components,
                    std::vector<std::string>& names) {
  const std::string prefix = prefix_of(sensor, blade);
  for (const SensorComponent& component : components) {
    names.push_back(prefix);
    if (!component.name.empty()) names.back() += '.' + std::string(component.name);
  }
}

ColumnNames::ColumnNames(IsTaken is_taken)
    : is_taken_(std::move(is_taken)),
      taken_{"hub.x",
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

std::string ColumnNames::add(const std::vector<std::string>& names) {
  count_ += names.size();
  if (count_ > kMostValues)
    return "makes " + std::to_string(count_) + " values with those before it, expected at most " +
           std::to_string(kMostValues);
  for (const std::string& name : names)
    if (is_taken_(name) || !taken_.insert(name).second)
      return "there is a column " + name + " already, expected a name of its own";
  return {};
}

}  // namespace spoke
