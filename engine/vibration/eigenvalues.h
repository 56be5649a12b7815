#pragma once

// The lowest eigenvalues of a pencil, and their vectors.

#include <vector>

#include "engine/vibration/pencil.h"
#include "engine/vibration/root.h"

namespace spoke::vibration {

/// The `count` roots of least magnitude, in ascending order, or all if there are fewer. Rigid
/// motions (find_rigid_motions()) are roots zero, one for each. Without damping and gyroscopic
/// forces, and with a symmetric stiffness, by the symmetric eigenproblem; else by the one of twice
/// the size, inverted: all of it if the pencil is small, a block Arnoldi iteration if it is large.
/// Blocks, because equal blades have equal roots, of which a single vector finds one.
std::vector<Root> find_roots(const Pencil& pencil, Eigen::Index count);

}  // namespace spoke::vibration
