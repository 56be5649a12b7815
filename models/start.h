#pragma once

// The drive that a simulation starts with, and how one from an equilibrium starts: at which speed,
// and without what only leads there.

#include <string>

#include "models/scenario.h"

namespace spoke {

/// What turns the hub, in the plane or in space.
const Drive& drive_of(const Scenario& scenario);

/// What is wrong with scenario.initial: the key below "initial", and in words what. Empty texts if
/// nothing is.
struct StartFault {
  std::string key, text;
};
StartFault find_start_fault(const Scenario& scenario);

/// The speed of the hub at t = 0 [rad/s]. Preconditions: initial.state is equilibrium, and there is
/// no fault.
double start_speed(const Scenario& scenario);

/// The scenario that is simulated: of one that starts at an equilibrium, ramps of loads and gravity
/// are over, and the drive begins at the start's speed. Others are as they are.
Scenario skip_start_up(const Scenario& scenario);

}  // namespace spoke
