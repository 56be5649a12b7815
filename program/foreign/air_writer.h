#pragma once

// Writes air, aerofoils and the aerodynamics of blades into a scenario.

#include <string>

#include "program/foreign/found_air.h"
#include "program/foreign/scenario_places.h"
#include "program/foreign/toml_text.h"

namespace spoke::foreign {

/// Returns the place of an aerofoil's table, relative to the scenario's folder.
std::string airfoil_path(const std::string& folder, const std::string& name);

/// Writes [blade.aerodynamics].
void write_blade_air(const FoundAir& air, Toml& toml);

/// Writes [support.body.drag] of the body before it.
void write_tower_air(const FoundTowerAir& tower, Toml& toml);

/// Where the rotor stands in the wind.
struct WindPlace {
  std::string downwind;  ///< a velocity along the rotor's axis, for an example of wind
  Value ground;          ///< its coordinate along z [m]; unknown where it says no source
};

/// Writes [air], [aerodynamics], [wind] and [[airfoil]]; without `files` polars stand in the text.
void write_air(const FoundAir& air, const ScenarioPlaces* files, const WindPlace& place,
               Toml& toml);

}  // namespace spoke::foreign
