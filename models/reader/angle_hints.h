#pragma once

// Angles that look as if they were given in degrees.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Questions, of each kind of angle about the first that is beyond what such an angle can sensibly
/// be in rad: "the azimuth of blade 2 is 120 rad, beyond a turn of 2 pi: degrees?". Nothing is
/// wrong with a scenario that has them.
std::vector<std::string> find_angle_hints(const Scenario& scenario);

}  // namespace spoke
