#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/simulation.h"

namespace spoke::test {

/// Returns what all sensors show.
inline std::vector<double> values_of(const Simulation& simulation) {
  const auto values = simulation.sensor_values();
  return {values.begin(), values.end()};
}

/// Returns what the sensor of three components `name` shows.
inline Eigen::Vector3d vector_of(const Simulation& simulation, const std::string& name) {
  return {simulation.sensor(name + ".x"), simulation.sensor(name + ".y"),
          simulation.sensor(name + ".z")};
}

}  // namespace spoke::test
