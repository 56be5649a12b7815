#pragma once

// Checks of a section's matrices while the place in the file is known.

#include <string>

#include "program/foreign/beam_table.h"

namespace spoke::foreign {

/// Makes a stiffness matrix symmetric. Returns what is wrong with it and what was expected; empty:
/// nothing. `asymmetry` grows to the largest difference of two entries, by the root of the product
/// of their diagonal entries.
std::string check_stiffness(SectionMatrix& matrix, double& asymmetry);

/// Does the same for the mass matrix of a slice, in BeamDyn's axes: one mass, a centre in the
/// section, thin.
std::string check_mass(SectionMatrix& matrix, double& asymmetry);

}  // namespace spoke::foreign
