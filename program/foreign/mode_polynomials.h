#pragma once

// Modes of a clamped beam as ElastoDyn has them: polynomials of the share of its length.

#include <array>
#include <vector>

namespace spoke::foreign {

/// A beam in one plane by its stations, linear between, and a mass at its tip.
struct PlaneBeam {
  std::vector<double> station;  ///< from 0 to the length [m]
  std::vector<double> mass;     ///< per length [kg/m]
  std::vector<double> bending;  ///< EI [N m^2]
  double tip_mass = 0.0;        ///< [kg]
};

/// A mode: its deflection is the sum of coefficient[i] (x/length)^(i + 2), 1 at the tip.
struct PolynomialMode {
  std::array<double, 5> coefficient{};
  double frequency = 0.0;  ///< [rad/s]
};

/// Returns the two lowest modes that such polynomials have (Rayleigh-Ritz).
std::array<PolynomialMode, 2> find_polynomial_modes(const PlaneBeam& beam);

}  // namespace spoke::foreign
