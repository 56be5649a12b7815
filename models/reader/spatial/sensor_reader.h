#pragma once

// Reads the [[sensor]] tables of a model in space.

#include <vector>

#include "models/reader/toml_section.h"
#include "models/sensor.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads the sensors. Throws InputError, also if two sensors would have columns of one name.
std::vector<Sensor> read_sensors(const TomlSection& root, const Model& model);

/// Checks sensors that are filled in code by the same rules. The model must be fine.
void check_sensors(const std::vector<Sensor>& sensors, const Model& model);

}  // namespace spoke::spatial
