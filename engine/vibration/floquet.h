#pragma once

// Floquet's analysis of a system with periodic matrices.

#include <complex>
#include <vector>

#include "engine/vibration/periodic_system.h"

namespace spoke::vibration {

/// A share of a motion: amplitude exp((s + i k w) t) at the speed w of the hub, where s is the
/// motion's exponent.
struct Harmonic {
  int multiple = 0;            ///< k
  Eigen::VectorXcd amplitude;  ///< of all coordinates
  double share = 0.0;          ///< of the kinetic energy by the mean mass matrix
};

/// A motion x = exp(s t) p(t), p periodic over a turn. It stands for a conjugate pair.
struct PeriodicMode {
  /// Its exponent, among those that differ by i w that of the strongest harmonic; its imaginary
  /// part is not negative [rad/s].
  std::complex<double> s;
  std::complex<double> multiplier;  ///< by which a turn multiplies it
  std::vector<Harmonic> harmonics;  ///< by ascending multiple; the strongest has 0
};

/// Largest number of coordinates: full matrices of their number are multiplied at each of many
/// steps.
constexpr Eigen::Index kMostPeriodic = 200;

/// Returns the `count` modes of least |s| in ascending order, or all if there are fewer. The states
/// over a turn are those of the Radau IIA method of fifth order, which takes what is too stiff for
/// its steps to zero; steps are halved until the multipliers of these modes are known to 1e-9.
/// Throws InputError if the hub does not turn, if there are more than kMostPeriodic coordinates, or
/// if the modes are too fast for 32768 steps over a turn.
std::vector<PeriodicMode> find_periodic_modes(const PeriodicSystem& system, Eigen::Index count);

}  // namespace spoke::vibration
