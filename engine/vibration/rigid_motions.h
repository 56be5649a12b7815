#pragma once

// Motions that nothing holds.

#include "engine/vibration/pencil.h"

namespace spoke::vibration {

/// Independent motions x without stiffness, K x = 0, as columns in scaled coordinates, orthonormal
/// by mass: by round-off of the terms that make up the forces of their own shapes, whatever else is
/// stiff. By subspace iteration on K + shift^2 M, with a shift [rad/s] far below what is held.
Eigen::MatrixXd find_rigid_motions(const Pencil& pencil, double shift);

}  // namespace spoke::vibration
