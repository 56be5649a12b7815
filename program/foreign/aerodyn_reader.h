#pragma once

// Reads AeroDyn's files (v15 and later): the primary one, of a blade, of an aerofoil.

#include <string>
#include <vector>

#include "program/foreign/beam_table.h"
#include "program/foreign/keyed_lines.h"
#include "program/foreign/polar_table.h"

namespace spoke::foreign {

/// What a primary file says besides what goes to the model.
struct AeroDynPrimary {
  std::vector<NamedFile> airfoils;  ///< by BlAFID
  NamedFile blade;
  bool has_moment = true;    ///< whether polars have a moment, and it is used
  bool is_by_table = false;  ///< whether all tables of an aerofoil are used, not the first only
};

/// A node of a blade, in AeroDyn's terms: x downwind, y towards the trailing edge, z along the
/// blade.
struct AeroDynNode {
  double span = 0.0;                ///< BlSpn, along the blade [m]
  double curve = 0.0, sweep = 0.0;  ///< BlCrvAC, BlSwpAC: x and y of the aerodynamic centre [m]
  double twist = 0.0;               ///< [degrees]
  double chord = 0.0;               ///< [m]
  std::size_t airfoil = 0;          ///< BlAFID less 1
  int line = 0;
};

/// Reads a primary file: the air and how it is modelled go to `model.air`, which must be there.
/// Throws InputError with file and line.
AeroDynPrimary read_aerodyn_primary(const SourceFile& source, FoundModel& model);

/// Reads a blade file, which may use so many aerofoils. Throws InputError with file and line.
std::vector<AeroDynNode> read_aerodyn_blade(const SourceFile& source, std::size_t airfoils);

/// Reads from a primary file what the model's tower does to the air; `foot`: its height over the
/// ground [m]. Throws InputError with file and line.
void read_aerodyn_tower(const SourceFile& source, double foot, FoundModel& model);

/// Polars of an aerofoil's file.
struct AeroDynPolars {
  FoundPolars polars;
  bool has_more = false;  ///< whether there are tables that AFTabMod passes over
};
/// Reads the polars of an aerofoil. Throws InputError with file and line.
AeroDynPolars read_aerodyn_polars(const SourceFile& source, const AeroDynPrimary& primary);

/// Gives `model.air` the aerodynamics of the model's blade: nodes become stations, their places
/// and twist are those against the blade's axis and sections. `names`: of the aerofoils, by
/// BlAFID. Throws InputError where nodes are beyond the blade's tip.
void add_aerodyn_blade(const std::vector<AeroDynNode>& nodes, const std::string& file,
                       const std::vector<std::string>& names, FoundModel& model);

}  // namespace spoke::foreign
