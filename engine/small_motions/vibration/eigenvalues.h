#pragma once

// The lowest eigenvalues of a pencil, and their vectors.

#include <vector>

#include "engine/small_motions/vibration/pencil.h"
#include "engine/small_motions/vibration/root.h"

namespace spoke::vibration {

/// Returns the `count` roots of least magnitude in ascending order, or all if there are fewer.
/// Rigid motions (find_rigid_motions()) are roots of zero, one for each. Without damping and
/// gyroscopic forces, and with a symmetric stiffness, the symmetric eigenproblem is solved;
/// otherwise the one of twice the size is inverted, and solved by its whole matrix if the pencil is
/// small, by a block Arnoldi iteration if it is large. The iteration uses blocks because equal
/// subsystems have equal roots, of which a single vector finds one.
std::vector<Root> find_roots(const Pencil& pencil, Eigen::Index count);

}  // namespace spoke::vibration
