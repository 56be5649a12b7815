#pragma once

// The lowest eigenvalues of a pencil without damping whose stiffness is symmetric.

#include <vector>

#include "engine/small_motions/vibration/pencil.h"
#include "engine/small_motions/vibration/root.h"

namespace spoke::vibration {

/// The shift of a pencil that needs one, by the frequency of the softest coordinate.
constexpr double kShift = 0.05;

/// Returns the rigid motions of a pencil that needs this shift; none where it is zero.
Eigen::MatrixXd find_rigid_motions_below(double shift, const Pencil& pencil);

/// Returns the `count` roots of least magnitude of a pencil that is symmetric, in ascending order,
/// with vectors of unit mass in scaled coordinates. A small pencil is solved by its whole matrix, a
/// large one by a block Lanczos iteration. Both go from the inverse of the stiffness, which keeps
/// the digits of the lowest roots and takes those of much higher ones, as of a solid on a soft
/// spring: these are found from an inverse that is shifted up to them, beside the motions that are
/// known by then.
std::vector<Root> find_symmetric_roots(const Pencil& pencil, Eigen::Index count);

}  // namespace spoke::vibration
