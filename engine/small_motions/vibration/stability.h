#pragma once

// Whether small motions are held, and whether they grow.

#include <complex>
#include <cstddef>
#include <vector>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// What the lowest roots of a linear model say.
struct RootStability {
  /// Number of motions that nothing holds, or that are pushed away: x^T K x is zero to round-off,
  /// or negative, by the eigenvalues of K against M, but for the stiffest quarter.
  std::size_t unheld = 0;
  std::size_t rigid = 0;         ///< those among them whose stiffness is zero to round-off
  double softest = 0.0;          ///< the least magnitude of such an eigenvalue but zero [1/s^2]
  double stiffest = 0.0;         ///< the largest of those that were looked at [1/s^2]
  double growth = 0.0;           ///< largest real part of a root by its magnitude; 0: none grows
  std::complex<double> growing;  ///< the root that grows most in this sense [1/s]
};

/// Looks at so many of the lowest roots, of each subsystem where they do not couple; at the growth
/// of those alone that are at most 1e4 times as fast as the slowest. `azimuths`: of subsystems
/// [rad].
RootStability assess_stability(const steady::LinearModel& linear,
                               const std::vector<double>& azimuths, int count);
/// Looks at the growth of so many of the lowest roots seen from outside, where what is held and
/// what is not cannot be told by K: it has forces of inertia, which gyroscopic ones balance.
RootStability assess_stability(const FixedFrame& frame, int count);

}  // namespace spoke::vibration
