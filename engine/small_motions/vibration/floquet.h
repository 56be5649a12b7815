#pragma once

// Floquet's analysis of a system with periodic matrices.

#include <vector>

#include "engine/small_motions/vibration/periodic_mode.h"
#include "engine/small_motions/vibration/periodic_system.h"

namespace spoke::vibration {

/// Largest number of coordinates, of each subsystem where the hub has none: full matrices of it are
/// kept for each harmonic.
constexpr Eigen::Index kMostPeriodic = 600;
/// Largest number where the hub has more than the six components of its own: a support's are not
/// reduced well, and take minutes beyond.
constexpr Eigen::Index kMostOnSupport = 100;

/// Throws InputError if the hub does not turn, or if there are more than kMostPeriodic coordinates.
void require_periodic(const PeriodicSystem& system);

/// Returns the `count` modes of least |s| in ascending order, or all if there are fewer. Subsystems
/// on a hub without coordinates are taken one by one. A large system is reduced to the low modes of
/// its mean matrices; what motions that are found leave without balance adds further ones, until
/// the multipliers stay within 1e-9. The states over a turn are those of the Radau IIA method of
/// order 13, which takes what is too stiff for its steps to zero; steps are halved until the
/// multipliers are known to 1e-9. Throws like require_periodic() and find_modes_over_turn().
std::vector<PeriodicMode> find_periodic_modes(const PeriodicSystem& system, Eigen::Index count);

}  // namespace spoke::vibration
