#pragma once

// A mode of a system with periodic matrices.

#include <Eigen/Core>
#include <complex>
#include <vector>

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

}  // namespace spoke::vibration
