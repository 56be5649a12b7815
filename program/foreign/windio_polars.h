#pragma once

// Reads the aerofoils of an ontology of WindIO.

#include <string>

#include "program/foreign/polar_table.h"
#include "program/foreign/windio_entry.h"

namespace spoke::foreign {

/// An aerofoil as it is at a place of the blade.
struct WindioAirfoil {
  std::string name;  ///< with the sets of polars, if these are named
  FoundPolars polars;
  double center = 0.0;    ///< of the aerodynamics, from the leading edge by the chord
  bool has_more = false;  ///< whether there are sets of polars that are not used
};

/// Finds an aerofoil of the ontology's `airfoils` by its name, with the polars of its first set or,
/// of version 2, those that `use` names with their weights: an entry of the blade's `airfoils`.
/// `name` has the name. `unit`: of angles [degrees]. Throws InputError.
WindioAirfoil read_windio_airfoil(const Entry& airfoils, const Entry& name, const Entry& use,
                                  double unit);

}  // namespace spoke::foreign
