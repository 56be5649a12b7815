#pragma once

// Reading and checking of sensors, common to the plane and space.

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "models/loop.h"
#include "models/reader/toml_section.h"
#include "models/sensor.h"

namespace spoke {

/// Reads the key `quantity`, which is required; those of solids are none of the plane.
SensorQuantity read_quantity(const TomlSection& section, bool in_plane);
/// Reads the key `frame` of a sensor, which must be a frame of its quantity.
SensorFrame read_sensor_frame(const TomlSection& section, SensorQuantity quantity);
/// Refuses the keys `blade`, `position`, `joint`, `loop`, `interface`, `node` and `frame` where a
/// sensor's quantity has no use for them.
void require_fitting_keys(const TomlSection& section, SensorQuantity quantity, bool in_plane);
/// Returns what is wrong with a sensor's frame; empty if nothing is.
std::string find_frame_fault(const Sensor& sensor);

/// Returns what is wrong with the loop that a sensor names, where it must be one of each of these
/// lists, of the blades or the subsystem that the sensor is on; empty if nothing is.
std::string find_loop_fault(const Sensor& sensor,
                            const std::vector<const std::vector<Loop>*>& loops);

/// Appends the names of the columns that a sensor has on a blade (from 0; of none, any number).
void append_columns(const Sensor& sensor, int blade, std::span<const SensorComponent> components,
                    std::vector<std::string>& names);

/// Names of columns that are taken: by every simulation, and by sensors.
class ColumnNames {
 public:
  using IsTaken = std::function<bool(const std::string&)>;

  /// Takes the names that every world has; `is_taken` says which further names are taken.
  explicit ColumnNames(IsTaken is_taken);
  /// Takes the columns of a sensor. Returns what is wrong with them; empty if nothing is.
  std::string add(const std::vector<std::string>& names);

 private:
  IsTaken is_taken_;
  std::set<std::string> taken_;
  std::size_t count_ = 0;
};

}  // namespace spoke
