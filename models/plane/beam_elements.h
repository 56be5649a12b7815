#pragma once

// The finite element: planar Euler-Bernoulli beam, linear axial and cubic (Hermite) bending shape
// functions; section rotary inertia and shear are neglected.

#include <vector>

#include "models/plane/beam_properties.h"
#include "models/plane/flexible_body.h"

namespace spoke::plane {

/// Assembles the constant integrals of a body, (P 3), element by element. Preconditions: all
/// numbers are positive; the pieces, if any, follow one another from 0 to the length.
FlexibleBody make_beam_body(const BeamProperties& beam);

/// Returns the centrifugal stiffness KG per squared hub speed [N s^2/m, ...] of a body whose frame
/// stands `distance` [m] from the hub axis and which carries the outboard bodies' first moment
/// `outboard` = int rhoA r dr [kg m]: int T(x) N_v'^T N_v' dx, with T(x) = int_x^L rhoA (distance +
/// xi) dxi + outboard the tension of the undeformed blade at unit hub speed. Point masses count as
/// rhoA does; their inertias J each add J N_v'^T N_v'.
SymmetricBand<3> make_centrifugal_stiffness(const BeamProperties& beam, double distance,
                                            double outboard);

/// Returns int m(x) N_v'^T N_v' dx [kg/m, ...] with m(x) the mass beyond x, which includes the mass
/// `outboard` [kg] of the bodies outboard: the stiffness due to the tension of a unit field that
/// acts on all masses alike.
SymmetricBand<3> make_outboard_mass_stiffness(const BeamProperties& beam, double outboard);

/// Returns int N_v'^T N_v' dx [1/m, 1, m]: half its quadratic form is the foreshortening of a bent
/// body.
SymmetricBand<3> make_slope_integral(const BeamProperties& beam);

/// Mass and stiffness of one element in the coordinates (u, v, psi) of its two nodes.
struct BeamElement {
  using Matrix = Eigen::Matrix<double, 2 * kTwist, 2 * kTwist>;
  Matrix mass = Matrix::Zero();
  Matrix stiffness = Matrix::Zero();
};

/// Returns the elements of a body from its inboard end; for a uniform body a single one, like all
/// of them.
std::vector<BeamElement> make_beam_elements(const BeamProperties& beam);

}  // namespace spoke::plane
