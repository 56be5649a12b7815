#pragma once

// The order of a nodal solid's coordinates, by slices that its factorisation leaves independent.

#include "models/space/solid.h"

namespace spoke::solid {

/// Orders the coordinates of a nodal solid by slices, and those that couple slices behind them,
/// each for little fill of the Cholesky factor of Mff + K; sets NodalSolid::slices. The number of
/// slices follows from the matrices alone. What is derived, space::set_derived(), is not ordered.
/// Precondition: the solid is nodal.
void order_coordinates(space::SolidConstants& solid);

/// Orders them so in at most `most` slices.
void order_coordinates(space::SolidConstants& solid, int most);

}  // namespace spoke::solid
