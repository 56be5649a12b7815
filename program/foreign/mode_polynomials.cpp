// The eigenvalue problem of five powers; integrals are exact, since properties are linear.

#include "program/foreign/mode_polynomials.h"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>

#include "models/support/gauss_rule.h"

namespace spoke::foreign {
namespace {

constexpr int kPowers = 5;
using PowerMatrix = Eigen::Matrix<double, kPowers, kPowers>;
using PowerVector = Eigen::Matrix<double, kPowers, 1>;

/// Returns x^2 to x^6.
PowerVector deflections_at(double x) {
  PowerVector values;
  for (int i = 0; i < kPowers; ++i) values[i] = std::pow(x, i + 2);
  return values;
}

/// Returns their second derivatives.
PowerVector curvatures_at(double x) {
  PowerVector values;
  for (int i = 0; i < kPowers; ++i) values[i] = (i + 2) * (i + 1) * std::pow(x, i);
  return values;
}

}  // namespace

std::array<PolynomialMode, 2> find_polynomial_modes(const PlaneBeam& beam) {
  using Rule = GaussRule<6>;  // exact up to the power of 11; a mass that grows has 13
  const double length = beam.station.back();
  PowerMatrix stiffness = PowerMatrix::Zero(), mass = PowerMatrix::Zero();
  for (std::size_t k = 1; k < beam.station.size(); ++k) {
    const double width = beam.station[k] - beam.station[k - 1];
    constexpr int parts = 4;
    for (int part = 0; part < parts; ++part)
      for (std::size_t q = 0; q < Rule::kPoints; ++q) {
        const double t = (part + Rule::places[q]) / parts;
        const double weight = Rule::weights[q] / parts * width / length;
        const double x = (beam.station[k - 1] + t * width) / length;
        const PowerVector shape = deflections_at(x), curvature = curvatures_at(x);
        stiffness += weight * std::lerp(beam.bending[k - 1], beam.bending[k], t) * curvature *
                     curvature.transpose();
        mass += weight * std::lerp(beam.mass[k - 1], beam.mass[k], t) * shape * shape.transpose();
      }
  }
  mass += beam.tip_mass / length * PowerMatrix::Ones();
  const Eigen::GeneralizedSelfAdjointEigenSolver<PowerMatrix> solver(stiffness, mass);
  assert(solver.info() == Eigen::Success);
  std::array<PolynomialMode, 2> modes;
  for (int m = 0; m < 2; ++m) {
    const PowerVector vector = solver.eigenvectors().col(m);
    const double tip = vector.sum();
    for (int i = 0; i < kPowers; ++i)
      modes[static_cast<std::size_t>(m)].coefficient[static_cast<std::size_t>(i)] = vector[i] / tip;
    modes[static_cast<std::size_t>(m)].frequency =
        std::sqrt(solver.eigenvalues()[m]) / (length * length);
  }
  return modes;
}

}  // namespace spoke::foreign
