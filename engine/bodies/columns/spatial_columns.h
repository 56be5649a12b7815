#pragma once

// The scenario's sensors on a model in space: their places on the subsystems, and their columns.

#include <span>
#include <vector>

#include "engine/bodies/columns/sensor_columns.h"
#include "engine/bodies/table/step_data.h"
#include "models/tree/tree.h"

namespace spoke {

/// Returns the number of values that the subsystems read in a step for these sensors; the first
/// `blades` of them are blades.
std::size_t count_readings(std::span<const Sensor> sensors, std::size_t blades,
                           const std::vector<spatial::Tree>& trees);

/// Lists the readings of every subsystem in the table, behind the `reading_count` values that there
/// are, and returns the columns, in the order of the sensors, their subsystems, and components.
/// Does not make the rings. Preconditions: the table is allocated, and spatial::check_sensors()
/// holds.
std::vector<SensorColumn> place_sensors(std::span<const Sensor> sensors, std::size_t blades,
                                        const std::vector<spatial::Tree>& trees,
                                        const System<Space>& system, StepData<Space>& data);

/// Makes the rings of all readings that are listed.
void make_reading_rings(StepData<Space>& data);

/// Returns the memory of the readings in the table [bytes].
std::size_t count_reading_bytes(const StepData<Space>& data);

/// Returns the value of a column at the end of step `step`, whose records, samples and readings
/// must be in the table.
double value_of(const SensorColumn& column, const space::Hub& hub, std::int64_t step,
                const StepData<Space>& data);

}  // namespace spoke
