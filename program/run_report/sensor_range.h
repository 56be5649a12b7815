#pragma once

// Finds the range that a sensor had in a run, by the sensor's name.

#include <algorithm>
#include <string_view>

#include "engine/results.h"
#include "engine/simulation.h"

namespace spoke::run_report {

/// Throws std::out_of_range if there is no such sensor.
inline const SensorRange& range_of(const Simulation& simulation, const SensorStatistics& statistics,
                                   std::string_view sensor) {
  const auto& names = simulation.sensor_names();
  const auto found = std::find(names.begin(), names.end(), sensor);
  return statistics.ranges().at(static_cast<std::size_t>(found - names.begin()));
}

}  // namespace spoke::run_report
