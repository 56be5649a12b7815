#pragma once

// Memory that the constants of a solid need, estimated before it is used.

#include "models/solid/solid.h"

namespace spoke::solid {

/// Returns the memory that making the constants of a solid needs at most [bytes]: matrices, factor,
/// shapes. Modes up to a frequency count as kUsualModes.
double estimate_memory(const spatial::SolidBody& body, const SolidGeometry& geometry);

/// Throws InputError, its place().key "mesh", if a factor with so many entries needs more than 0.8
/// of `memory` [bytes].
void require_factor_memory(double entries, double memory);

/// Throws InputError, its place().key "up_to", if so many modes and static shapes of a body with
/// `unknowns` displacements of nodes need more than 0.8 of `memory` [bytes].
void require_mode_memory(double modes, double unknowns, double memory);

/// Throws InputError, its place().key "mesh", if making the constants needs more than 0.8 of
/// `memory` [bytes], which is all that may be used; see estimate_memory().
void require_memory(const spatial::SolidBody& body, const SolidGeometry& geometry, double memory);

}  // namespace spoke::solid
