#pragma once

// Writes TurbSim's full-field binary files (.bts).

#include <string>

#include "models/air/wind_box.h"

namespace spoke::air {

/// Returns the bytes of a file of a box, whose hub is at this height [m]. Velocities are rounded to
/// a 65535th of the range of their component.
std::string make_bts(const WindBox& box, double hub_height, const std::string& description);

}  // namespace spoke::air
