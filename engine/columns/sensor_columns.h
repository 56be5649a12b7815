#pragma once

// The scenario's sensors: where they are on the blades, and the columns that show them.

#include <span>
#include <string>
#include <vector>

#include "engine/table/step_data.h"
#include "models/rotor.h"
#include "models/sensor.h"

namespace spoke {

/// One value of a sensor.
struct SensorColumn {
  std::string name;
  std::string unit;
  SensorQuantity quantity = SensorQuantity::displacement;
  SensorFrame frame = SensorFrame::hub;
  std::size_t component = 0;
  std::size_t blade = 0;            ///< of a sensor of a blade
  std::vector<std::size_t> places;  ///< of its readings: on that blade, or on every one
};

/// Appends the columns of a sensor on a blade, or tree; `places`: see SensorColumn.
void add_columns(const Sensor& sensor, std::size_t blade,
                 std::span<const SensorComponent> components,
                 const std::vector<std::size_t>& places, std::vector<SensorColumn>& columns);

/// Values that the blades take in a step for these sensors.
std::size_t count_readings(std::span<const Sensor> sensors, std::size_t blades);

/// Lists the readings of every blade in the table, with their ring, and returns the columns, in the
/// order of the sensors, their blades, and components. Preconditions: the table is allocated, and
/// check_sensors() holds.
std::vector<SensorColumn> place_sensors(std::span<const Sensor> sensors, const Rotor& rotor,
                                        StepData<Plane>& data);

/// Memory of the mass points that readings in the table integrate over [bytes].
std::size_t count_mass_bytes(const StepData<Plane>& data);

/// The value of a column at the end of step `step`, of which records, samples and readings must be
/// in the table.
double value_of(const SensorColumn& column, const Hub& hub, std::int64_t step,
                const StepData<Plane>& data);

}  // namespace spoke
