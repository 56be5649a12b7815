#pragma once

// Checks scenarios that are filled in code.

#include "models/scenario.h"

namespace spoke {

/// Throws InputError unless a scenario that was filled in code could stand in a file: "KEY: what is
/// wrong, what is expected", the key as to_json() has it, blades and loads counted from 1.
void check_scenario(const Scenario& scenario);

/// Throws InputError unless a drive that was filled in code could stand in a file.
void check_drive(const Drive& drive);

/// Throws InputError unless `after` can take over from `before` at time t [s]: prescribes the hub's
/// rotation or leaves it free as `before` does, and goes on from where the hub then is.
void check_continuation(const Drive& before, const Drive& after, double t);

}  // namespace spoke
