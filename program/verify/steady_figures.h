#pragma once

// Figures of equilibria.

#include "engine/equilibrium.h"
#include "program/verify/case.h"

namespace spoke::verify {

/// Returns a quantity of a blade or subsystem, `figure.number`, or of the hub. Throws InputError if
/// there is none of the name.
double read_steady(const EquilibriumResult& result, const Figure& figure);

}  // namespace spoke::verify
