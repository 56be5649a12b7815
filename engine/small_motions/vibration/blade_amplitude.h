#pragma once

// Amplitudes of patterns of blades, and the means over a turn of what they multiply.

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/small_motions/vibration/standing_axes.h"

namespace spoke::vibration {

/// An amplitude of a pattern: blades have its values times 1, cos n psi_b, sin n psi_b or (-1)^b.
struct Amplitude {
  std::size_t pattern = 0;
  int multiple = 0;  ///< n
  bool is_sine = false;
  bool is_differential = false;
  Eigen::Index at = 0;  ///< of its coordinates among all
  std::string name{};   ///< "collective"; of a shaft empty

  /// Returns the name of this amplitude of a signal.
  std::string of(const std::string& signal) const {
    return name.empty() ? signal : signal + ' ' + name;
  }

  double at_azimuth(double psi) const {
    if (multiple == 0 || is_differential) return 1.0;
    return is_sine ? std::sin(multiple * psi) : std::cos(multiple * psi);
  }
  /// Number of blades by the sum of the squares of what is above.
  double size() const { return multiple == 0 || is_differential ? 1.0 : 2.0; }
};

/// Means over the azimuth of a product with 1, cos psi and sin psi.
struct Means {
  double mean, cosine, sine;
  Eigen::MatrixXd of(const Turning& values) const {
    return mean * values.mean + cosine * values.cosine + sine * values.sine;
  }
};

/// Returns the mean over a turn of the product of two patterns and what follows it.
inline Means average(const Amplitude& a, const Amplitude& b) {
  Means means{0.0, 0.0, 0.0};
  if (a.is_differential != b.is_differential) return means;
  const int count = a.multiple + b.multiple + 3;
  for (int k = 0; k < count; ++k) {
    const double psi = 2.0 * std::numbers::pi * k / count;
    const double product = a.at_azimuth(psi) * b.at_azimuth(psi) / count;
    means.mean += product;
    means.cosine += product * std::cos(psi);
    means.sine += product * std::sin(psi);
  }
  for (double* mean : {&means.mean, &means.cosine, &means.sine})
    if (std::abs(*mean) < 1e-12) *mean = 0.0;  // round-off
  return means;
}

/// Returns the mean over a turn of T h times a pattern.
inline Eigen::VectorXd average_on_hub(const Turning& T, const Turning& h, const Amplitude& by) {
  const Amplitude cosine{.multiple = 1}, sine{.multiple = 1, .is_sine = true}, all{};
  return T.mean * average(all, by).of(h) + T.cosine * average(cosine, by).of(h) +
         T.sine * average(sine, by).of(h);
}

}  // namespace spoke::vibration
