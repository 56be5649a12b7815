#pragma once

// Fourier series of functions of the azimuth, from their values at equal parts of a turn.

#include <Eigen/Core>
#include <complex>

namespace spoke::vibration {

/// Returns the harmonics c_k, in columns k = 0 to H, of functions with values in columns at the
/// azimuths 2 pi l / (2 H + 1): f(psi) = c_0 + 2 Re sum c_k exp(i k psi).
Eigen::MatrixXcd find_harmonics(const Eigen::MatrixXd& values);

/// Returns the values in columns, as many as there are `parts` of a turn.
Eigen::MatrixXd sum_harmonics(const Eigen::MatrixXcd& harmonics, Eigen::Index parts);

/// Returns the harmonics of the derivatives by the azimuth.
Eigen::MatrixXcd differ_by_azimuth(const Eigen::MatrixXcd& harmonics);

/// Returns the harmonics of f(psi + angle).
Eigen::MatrixXcd shift_azimuth(const Eigen::MatrixXcd& harmonics, double angle);

}  // namespace spoke::vibration
