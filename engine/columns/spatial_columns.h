#pragma once

// The scenario's sensors on a model in space: where they are on its trees, and their columns.

#include <span>
#include <vector>

#include "engine/columns/sensor_columns.h"
#include "engine/table/step_data.h"
#include "models/tree/tree.h"

namespace spoke {

/// Values that the trees take in a step for these sensors; `blades`: how many of them are blades.
std::size_t count_readings(std::span<const Sensor> sensors, std::size_t blades,
                           const std::vector<spatial::Tree>& trees);

/// Lists the readings of every tree in the table, behind `reading_count` values that there are, and
/// returns the columns, in the order of the sensors, their trees, and components. The rings are
/// left to be made. Preconditions: the table is allocated, and spatial::check_sensors() holds.
std::vector<SensorColumn> place_sensors(std::span<const Sensor> sensors, std::size_t blades,
                                        const std::vector<spatial::Tree>& trees,
                                        const System<Space>& system, StepData<Space>& data);

/// Makes the rings of all readings that were listed.
void make_reading_rings(StepData<Space>& data);

/// Memory of the readings in the table [bytes].
std::size_t count_reading_bytes(const StepData<Space>& data);

/// The value of a column at the end of step `step`, of which records, samples and readings must be
/// in the table.
double value_of(const SensorColumn& column, const space::Hub& hub, std::int64_t step,
                const StepData<Space>& data);

}  // namespace spoke
