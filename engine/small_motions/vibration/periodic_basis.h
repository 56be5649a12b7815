#pragma once

// Reduces a periodic system to motions that make up its modes.

#include <vector>

#include "engine/small_motions/vibration/periodic_mode.h"
#include "engine/small_motions/vibration/periodic_system.h"

namespace spoke::vibration {

/// Returns the system for coordinates y of x = V y, without units of force: V^T A V of each matrix.
PeriodicSystem project(const PeriodicSystem& system, const Eigen::MatrixXd& V);

/// Finds a basis for the `count` lowest modes, with columns of unit mass by the mean mass matrix
/// and without common mass: the modes of the mean stiffness up to three times their frequencies.
Eigen::MatrixXd find_low_motions(const PeriodicSystem& system, Eigen::Index count);

/// Returns columns to be added to the basis V, which remains such a one: what lies beyond it in the
/// answers of the mean stiffness to the forces that these modes leave without balance. None if they
/// are below 1e-7 of the modes.
Eigen::MatrixXd find_missing_motions(const PeriodicSystem& system, const Eigen::MatrixXd& V,
                                     const std::vector<PeriodicMode>& modes);

}  // namespace spoke::vibration
