#pragma once

// Motions that nothing holds.

#include "engine/small_motions/vibration/pencil.h"

namespace spoke::vibration {

/// Returns independent motions x without stiffness, K x = 0, as columns in scaled coordinates,
/// orthonormal by mass. Stiffness counts as none if it is within round-off of the terms that make
/// up the forces of the same shape, however stiff other motions are. Subspace iteration on K +
/// shift^2 M finds them, with a shift [rad/s] far below the frequencies of motions that are held.
Eigen::MatrixXd find_rigid_motions(const Pencil& pencil, double shift);

}  // namespace spoke::vibration
