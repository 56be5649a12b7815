#pragma once

// The scenario's sensors in the plane: their places on the subsystems, and the columns that show
// them.

#include <algorithm>
#include <cassert>
#include <span>
#include <string>
#include <vector>

#include "engine/bodies/table/step_data.h"
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
  std::size_t subsystem = 0;        ///< number of the subsystem; 0 for a sensor of the whole system
  std::vector<std::size_t> places;  ///< places of its readings: on that subsystem, or on every one
};

/// Returns the index of the loop of that name, which is one of them.
template <class AnyLoop>
std::size_t find_loop(const std::vector<AnyLoop>& loops, const std::string& name) {
  const auto at = std::find_if(loops.begin(), loops.end(),
                               [&](const AnyLoop& loop) { return loop.name == name; });
  assert(at != loops.end());
  return static_cast<std::size_t>(at - loops.begin());
}

/// Returns the value of a quantity that samples of a subsystem have anyway; null: they have none.
template <class World>
const double* find_sampled(SensorQuantity quantity, const SubsystemSample<World>& sample) {
  if (quantity == SensorQuantity::strain_energy) return &sample.strain;
  return quantity == SensorQuantity::kinetic_energy ? &sample.kinetic : nullptr;
}

/// Whether subsystems take a reading for the quantity; otherwise the table has it anyway.
inline bool needs_reading(SensorQuantity quantity) {
  const SubsystemSample<Plane> any;
  return quantity != SensorQuantity::hub_reaction && !find_sampled(quantity, any);
}

/// Appends the columns of a sensor on a subsystem; `places`: see SensorColumn.
void add_columns(const Sensor& sensor, std::size_t subsystem,
                 std::span<const SensorComponent> components,
                 const std::vector<std::size_t>& places, std::vector<SensorColumn>& columns);

/// Returns the number of values that the subsystems read in a step for these sensors.
std::size_t count_readings(std::span<const Sensor> sensors, std::size_t subsystems);

/// Lists the readings of every subsystem in the table, makes their rings, and returns the columns,
/// in the order of the sensors, their subsystems, and components. Preconditions: the table is
/// allocated, and check_sensors() holds.
std::vector<SensorColumn> place_sensors(std::span<const Sensor> sensors, const Rotor& rotor,
                                        StepData<Plane>& data);

/// Returns the memory of the mass points that readings in the table integrate over [bytes].
std::size_t count_mass_bytes(const StepData<Plane>& data);

/// Returns the value of a column at the end of step `step`, whose records, samples and readings
/// must be in the table.
double value_of(const SensorColumn& column, const Hub& hub, std::int64_t step,
                const StepData<Plane>& data);

}  // namespace spoke
