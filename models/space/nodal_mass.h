#pragma once

// The mass matrix of a solid's nodal coordinates.

#include "models/space/solid.h"

namespace spoke::space {

/// Returns Mff = Xi^T (m (x) 1_3) Xi.
Eigen::SparseMatrix<double> calc_flexible_mass(const NodalSolid& solid);

}  // namespace spoke::space
