#pragma once

// Hints at angles that look as if they were given in degrees.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns one question for each kind of angle that has a value beyond any sensible one in rad:
/// "the azimuth of blade 2 is 120 rad, beyond a turn of 2 pi: degrees?". Such a scenario is still
/// valid.
std::vector<std::string> find_angle_hints(const Scenario& scenario);

}  // namespace spoke
