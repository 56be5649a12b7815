#pragma once

// Loads by their names, and scenarios with a factor of one of them.

#include <string>

#include "models/scenario.h"

namespace spoke::vibration {

/// Throws InputError unless there are loads of this name, or it is "gravity", and a factor changes
/// the steady state by them.
void require_load(const Scenario& scenario, const std::string& name);

/// Multiplies all loads of a name by a factor.
void multiply_load(const std::string& name, double factor, Scenario& scenario);

}  // namespace spoke::vibration
