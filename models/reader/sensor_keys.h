#pragma once

// What reading and checking sensors of the plane and of space have in common.

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "models/reader/toml_section.h"
#include "models/sensor.h"

namespace spoke {

/// The key `quantity`, which is required.
SensorQuantity read_quantity(const TomlSection& section);
/// The key `frame` of a sensor, one of those of its quantity.
SensorFrame read_sensor_frame(const TomlSection& section, SensorQuantity quantity);
/// Refuses the keys `blade`, `position`, `joint` and `frame` where a sensor's quantity has no use
/// for them.
void require_fitting_keys(const TomlSection& section, SensorQuantity quantity);
/// What is wrong with a sensor's frame, or nothing.
std::string find_frame_fault(const Sensor& sensor);

/// Appends the names of the columns that a sensor has on a blade (from 0; of none, any number).
void append_columns(const Sensor& sensor, int blade, std::span<const SensorComponent> components,
                    std::vector<std::string>& names);

/// Names of columns that are taken: those that every simulation has, and those of sensors.
class ColumnNames {
 public:
  using IsTaken = std::function<bool(const std::string&)>;

  /// Takes those that every world has, and all of which `is_taken` says so.
  explicit ColumnNames(IsTaken is_taken);
  /// Takes the columns of a sensor. What is wrong with them, or nothing.
  std::string add(const std::vector<std::string>& names);

 private:
  IsTaken is_taken_;
  std::set<std::string> taken_;
  std::size_t count_ = 0;
};

}  // namespace spoke
