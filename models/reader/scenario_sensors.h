#pragma once

// Reads the [[sensor]] tables of a scenario.

#include <vector>

#include "models/reader/toml_section.h"
#include "models/scenario.h"

namespace spoke {

/// Reads the sensors. Throws InputError, also if two sensors would have columns of one name.
std::vector<Sensor> read_sensors(const TomlSection& root, const std::vector<Blade>& blades);

/// Checks sensors that are filled in code by the same rules. The blades must be fine.
void check_sensors(const std::vector<Sensor>& sensors, const std::vector<Blade>& blades);

}  // namespace spoke
