#pragma once

// The finite element: planar Euler-Bernoulli beam, linear axial and cubic (Hermite) bending shape
// functions; section rotary inertia and shear are neglected.

#include <compare>

#include "models/system/flexible_body.h"

namespace spoke {

/// One body of a beam.
struct BeamProperties {
  double length = 0.0;             ///< of the body [m]
  int elements = 1;                ///< of equal length
  double mass_per_length = 0.0;    ///< rhoA [kg/m]
  double axial_stiffness = 0.0;    ///< EA [N]
  double bending_stiffness = 0.0;  ///< EI [N m^2]
  ReferenceFrame reference_frame = ReferenceFrame::clamped;

  auto operator<=>(const BeamProperties&) const = default;
};

/// Properties of one of the equal bodies of a blade.
BeamProperties make_beam_properties(const Blade& blade);

/// Assembles the constant integrals of a body, (P 3), element by element.
/// Precondition: all numbers positive.
FlexibleBody make_beam_body(const BeamProperties& beam);

/// The centrifugal stiffness KG per squared hub speed [N s^2/m, ...] of a body whose frame stands
/// `distance` [m] from the hub axis and which carries the outboard bodies' first moment `outboard`
/// = int rhoA r dr [kg m]: int T(x) N_v'^T N_v' dx, with T(x) = int_x^L rhoA (distance + xi) dxi +
/// outboard the tension of the undeformed blade at unit hub speed.
SymmetricBand<3> make_centrifugal_stiffness(const BeamProperties& beam, double distance,
                                            double outboard);

/// int N_v'^T N_v' dx [1/m, 1, m]: half its quadratic form is the foreshortening of a bent body.
SymmetricBand<3> make_slope_integral(const BeamProperties& beam);

/// Mass and stiffness of one element in the coordinates (u, v, psi) of its two nodes.
struct BeamElement {
  using Matrix = Eigen::Matrix<double, 2 * kTwist, 2 * kTwist>;
  Matrix mass;
  Matrix stiffness;
};

/// The element of a beam whose bodies are `beam`.
BeamElement make_beam_element(const BeamProperties& beam);

}  // namespace spoke
