#pragma once

// Memory that the constants of a solid need, estimated before it is used.

#include "models/solid/solid.h"

namespace spoke::solid {

/// Returns the memory that making the constants of a solid needs at most [bytes]: matrices, factor,
/// shapes.
double estimate_memory(const spatial::SolidBody& body, const SolidGeometry& geometry);

/// Throws InputError, its place().key "mesh", if a factor with so many entries does not fit into
/// `memory` [bytes].
void require_factor_memory(double entries, double memory);

/// Throws InputError, its place().key "mesh", if making the constants needs more memory than the
/// there is [bytes].
void require_memory(const spatial::SolidBody& body, const SolidGeometry& geometry, double memory);

}  // namespace spoke::solid
