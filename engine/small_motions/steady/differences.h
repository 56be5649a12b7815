#pragma once

// Central differences.

#include <Eigen/Core>

namespace spoke::steady {

// Steps of the differences, by the scale of a coordinate. The error of fourth order is h^4/30 of
// the fifth derivative, 1e-14 at this step; round-off is 1e-16/h of the size of the forces.
constexpr double kStep = 1e-3;
constexpr double kVelocityStep = 1e-3;

/// Returns the derivative of `at`, a function of a distance that yields a vector, to second order.
template <class At>
Eigen::VectorXd differ(double h, const At& at) {
  return (at(h) - at(-h)) / (2.0 * h);
}

/// Returns the same derivative to fourth order.
template <class At>
Eigen::VectorXd differ_finely(double h, const At& at) {
  return (4.0 * differ(h, at) - differ(2.0 * h, at)) / 3.0;
}

}  // namespace spoke::steady
