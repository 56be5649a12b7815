#pragma once

// An eigenvalue of a pencil, and its vector.

#include <Eigen/Core>
#include <complex>

namespace spoke::vibration {

/// A root s of the pencil with its vector x of unit mass, x^H M x = 1, in coordinates of the model.
/// It stands for a conjugate pair by the root with positive imaginary part.
struct Root {
  std::complex<double> s;  ///< [rad/s]
  Eigen::VectorXcd x;
};

}  // namespace spoke::vibration
