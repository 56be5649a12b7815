#pragma once

// A cross section anywhere on a body, by the finite element's shape functions: linear for axial
// displacements, cubic (Hermite) for bending.

#include <array>

#include "engine/bodies/plane/flex_layout.h"
#include "models/plane/flexible_body.h"

namespace spoke::plane {

/// The coordinates that move a section, and how much: a quantity is the sum of its shape functions
/// times the values at these places of a flex vector (place 0 for a coordinate that is fixed).
struct Section {
  double x = 0.0;  ///< undeformed place in the body frame [m]
  std::array<int, 2> axial_at{};
  std::array<int, 4> bending_at{};  ///< v, psi of the element's inner node, then of the outer
  std::array<double, 2> axial{};    ///< shape functions of u
  std::array<double, 2> strain{};   ///< shape functions of u' [1/m]
  std::array<double, 4> deflection{};
  std::array<double, 4> slope{};             ///< shape functions of v'
  std::array<double, 4> curvature{};         ///< shape functions of v''
  std::array<double, 4> curvature_change{};  ///< shape functions of v'''
};

/// Makes the section of element `e` at `s`, 0 at its inboard end, 1 at the outboard end.
Section make_section(const FlexibleBody& body, const FlexLayout& layout, int e, double s);

/// Makes the section at `station`, 0 at the body's inboard end, 1 at the outboard end. Between two
/// elements, where the derivatives jump, it is that of the outer one.
Section make_section(const FlexibleBody& body, const FlexLayout& layout, double station);

/// Returns a quantity of a section: `shape` functions of the coordinates at `places` of a flex
/// vector.
template <std::size_t n>
double value_at(const std::array<double, n>& shape, const std::array<int, n>& places,
                const double* flex) {
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) sum += shape[k] * flex[places[k]];
  return sum;
}

/// Returns displacement u, v and rotation psi = v' of a section, or their rates.
inline Twist section_values(const Section& section, const double* flex) {
  return {value_at(section.axial, section.axial_at, flex),
          value_at(section.deflection, section.bending_at, flex),
          value_at(section.slope, section.bending_at, flex)};
}

}  // namespace spoke::plane
