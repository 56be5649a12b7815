#pragma once

// Geometric stiffening of a spatial body: terms of tension and of the turning of its sections in
// the energies, to second order in the deformation (docs/formulation.md, section 10):
//   T = T_linear - 1/2 w0^T Lambda w0,     V = V_linear + g . gamma
//   Lambda = (e.c) 1 - 1/2 (e c^T + c e^T) + (share of sections and small masses that turn)
//   c = sum S K1 + R KL + e Kx,            gamma = 1/2 (sum m_out K1 + KL) e
// with the quadratic forms q^T K q in place of the matrices K. K1 is summed over the elements,
// which carry the mass m_out with the first moment S.

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

/// Quadratic forms q^T K q' of the matrices of a tension.
struct TensionForms {
  Position carried = Position::Zero();  ///< sum S K1
  double carried_mass = 0.0;            ///< sum m_out K1
  double KL = 0.0;
  double Kx = 0.0;
};

/// Quadratic forms of the stiffening in two flex vectors.
struct StiffeningForms {
  TensionForms tension;
  /// Share in Lambda of sections (turned_sections.h) and small masses that turn, in B.
  Matrix3 inertias = Matrix3::Zero();
};

/// Forms q^T K q and q^T K q' of the stiffening.
struct StiffeningSums {
  StiffeningForms value;
  StiffeningForms rate;
};

/// Adds the stiffening's forces -K q to those by node, and sums its forms. `q`, `v`: by node.
StiffeningSums add_stiffening(const BodyModel& model, const BodyMotion& motion, const double* q,
                              const double* v, double* force) noexcept;

/// Returns the forms q^T K q alone, to the bits of add_stiffening(); what energies need.
StiffeningForms calc_stiffening_forms(const BodyModel& model, const double* q) noexcept;

/// Returns int (v' V' + w' W') ds of the slopes of two flex vectors against the elements' axes [m],
/// up to xi, 0 to 1, of an element. Both by node.
double sum_slope_products(const FlexibleBody& body, const double* q, const double* p, int element,
                          double xi) noexcept;

/// Returns Lambda alone, in H.
Matrix3 calc_hub_inertia(const TensionPlace& place, const StiffeningForms& forms) noexcept;
/// Returns Lambda, Lambda' and g x gamma; `gravity`: in H [m/s^2].
HubStiffening calc_hub_stiffening(const TensionPlace& place, const Position& gravity,
                                  const StiffeningSums& sums) noexcept;

/// Returns gamma: the energy of gravity's tension is g . gamma, in H [kg m].
Position calc_tension_moment(const TensionPlace& place, const StiffeningForms& forms) noexcept;
/// Returns gamma and its rate. It is quadratic in q: its rate is that of q^T K q', twice.
inline TensionMoment calc_tension_moment(const TensionPlace& place, const StiffeningSums& sums) {
  return {calc_tension_moment(place, sums.value), 2.0 * calc_tension_moment(place, sums.rate)};
}

}  // namespace spoke::space
