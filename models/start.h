#pragma once

// The drive that a simulation starts with, and how a simulation from an equilibrium starts: its hub
// speed, without the ramps that only lead there.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns the drive of the hub, in the plane or in space.
const Drive& drive_of(const Scenario& scenario);

/// A fault in scenario.initial: the key below "initial", and what is wrong in words. Both texts are
/// empty if there is none.
struct StartFault {
  std::string key, text;
};
StartFault find_start_fault(const Scenario& scenario);

/// What messages about a start at an equilibrium that there is not end with: the way out.
inline constexpr const char* kStartUndeformed = "; --set initial={} starts without equilibrium";

/// Returns the speed of the hub at t = 0 [rad/s]. Preconditions: initial.state is equilibrium, and
/// there is no fault.
double start_speed(const Scenario& scenario);
/// Returns those of the hubs of all rotors, in their order.
std::vector<double> start_speeds(const Scenario& scenario);

/// Returns the scenario that is simulated. If it starts at an equilibrium, ramps of loads and
/// gravity are over, and the drive begins at the start's speed; any other scenario is returned
/// unchanged.
Scenario skip_start_up(const Scenario& scenario);

}  // namespace spoke
