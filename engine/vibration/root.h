#pragma once

// An eigenvalue of a pencil, and its vector.

#include <Eigen/Core>
#include <complex>

namespace spoke::vibration {

/// A root s of the pencil with its vector x, in coordinates of the model, of unit mass:
/// x^H M x = 1. Of a pair of conjugate ones that with the positive imaginary part.
struct Root {
  std::complex<double> s;  ///< [rad/s]
  Eigen::VectorXcd x;
};

}  // namespace spoke::vibration
