#pragma once

// The terms of a solid's equation of motion at a state, (P 3) of a body from a mesh
// (docs/formulation.md, section 13).

#include "engine/bodies/kinds/solid/solid_model.h"
#include "engine/bodies/space/body_energies.h"
#include "models/rotor.h"

namespace spoke::space {

/// Calculates the state-dependent mass terms and the right-hand side of a solid, without loads, as
/// calc_body_terms() does of a beam: of a reduced one in r modes, with p_ab = h_ba^T + m_ab q,
///   J_ab = J0_ab + x_a^T m Phi_b q + q.p_ab,   G_ab = p_ba.q',   C_w,k^T = p_ba - p_ab
///   Q_f = - sum A_ab p_ab - 2 sum_k w_k sum_ab eps_akb m_ab q' - K q - D q' - K_G q
BodyTerms calc_solid_terms(const SolidModel& model, const BodyState& state,
                           const BodyMotion& motion, const Damping& damping,
                           const BodyWork& work) noexcept;

/// Calculates the energies of a solid, as calc_body_energies() does of a beam.
BodyEnergies calc_solid_energies(const SolidModel& model, const BodyState& state,
                                 const Twist& twist, const BodyMotion& motion,
                                 const BodyWork& work) noexcept;

/// Returns Lambda of its stiffening, in H. Precondition: it is stiffened in its tree.
Matrix3 calc_stiffening_inertia(const SolidModel& model, const BodyState& state,
                                const BodyWork& work) noexcept;

/// Returns the momentum of a solid and its moment about B's origin, in B; without the share of the
/// hub's stiffening.
Twist calc_solid_momentum(const SolidModel& model, const BodyState& state, const Twist& twist,
                          const BodyWork& work) noexcept;

/// Returns the elastic energy of a solid [J].
double calc_strain_energy(const Solid& body, const double* q) noexcept;

}  // namespace spoke::space
