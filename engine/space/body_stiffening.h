#pragma once

// Geometric stiffening of a spatial body: what tension and the turning of its sections add to the
// energies to second order in the deformation (docs/formulation.md, section 10).

#include "engine/space/body_data.h"

namespace spoke::space {

/// Quadratic forms q^T K q' of the matrices of a tension.
struct TensionForms {
  Position carried = Position::Zero();  ///< first moments that elements carry, times those of K1
  double carried_mass = 0.0;            ///< the masses, times those of K1
  double KL = 0.0;
  double Kx = 0.0;
};

/// Quadratic forms of the stiffening in two flex vectors.
struct StiffeningForms {
  TensionForms tension;
  Matrix3 propeller = Matrix3::Zero();  ///< of the propeller matrices, a symmetric tensor in B
  Matrix3 inertias = Matrix3::Zero();   ///< of small masses: their share of Lambda, in B
};

/// Sums of q^T K q and of q^T K q'.
struct StiffeningSums {
  StiffeningForms value;
  StiffeningForms rate;
};

/// Adds the stiffening's forces to those by node, and sums its forms. `q`, `v`: by node.
StiffeningSums add_stiffening(const BodyModel& model, const BodyMotion& motion, const double* q,
                              const double* v, double* force) noexcept;

/// int (v' V' + w' W') ds of the slopes of two flex vectors against the elements' axes [m], up to
/// xi, 0 to 1, of an element. Both by node.
double sum_slope_products(const FlexibleBody& body, const double* q, const double* p, int element,
                          double xi) noexcept;

/// What the hub feels of it; `gravity`: in H [m/s^2].
HubStiffening calc_hub_stiffening(const TensionPlace& place, const Position& gravity,
                                  const StiffeningSums& sums) noexcept;

/// gamma: the energy of gravity's tension is g . gamma, in H [kg m].
Position calc_tension_moment(const TensionPlace& place, const StiffeningForms& forms) noexcept;
/// It is quadratic in q: its rate is that of q^T K q', twice.
inline TensionMoment calc_tension_moment(const TensionPlace& place, const StiffeningSums& sums) {
  return {calc_tension_moment(place, sums.value), 2.0 * calc_tension_moment(place, sums.rate)};
}

}  // namespace spoke::space
