#pragma once

#include "models/scenario.h"

namespace spoke {

/// Throws InputError unless a scenario that was filled in code could stand in a file: "KEY: what is
/// wrong, what is expected", the key as to_json() has it, blades and loads counted from 1.
void check_scenario(const Scenario& scenario);

/// The same of a drive.
void check_drive(const Drive& drive);

}  // namespace spoke
