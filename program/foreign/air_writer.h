#pragma once

// Writes air, aerofoils and the aerodynamics of blades into a scenario.

#include <string>

#include "program/foreign/found_air.h"
#include "program/foreign/toml_text.h"

namespace spoke::foreign {

/// Returns the place of an aerofoil's table, relative to the scenario's folder.
std::string airfoil_path(const std::string& folder, const std::string& name);

/// Writes [[blade.joint]], by which the blades pitch, and [blade.aerodynamics]. `pitch`: about
/// +x [rad].
void write_blade_air(const FoundAir& air, const Value& pitch, Toml& toml);

/// Writes [air], [aerodynamics] and [[airfoil]]; these name tables in `folder`, or have the polars
/// themselves if it is empty. `downwind`: the rotor's axis, for an example of wind.
void write_air(const FoundAir& air, const std::string& folder, const std::string& downwind,
               Toml& toml);

}  // namespace spoke::foreign
