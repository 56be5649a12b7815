#pragma once

// The terms of a spatial body's equation of motion at a state, (P 3) in space.

#include "engine/bodies/space/body_data.h"
#include "models/rotor.h"

namespace spoke::space {

/// Calculates the state-dependent mass terms and the right-hand side of a body, without loads: the
/// terms, and the rows C_w^T and Q_f of `work`. With sums over the slots rho and mu = m rho,
///   S = sum e mu,  Theta = tr(J) 1 - J,  J = sum rho mu^T,  G = sum rho mu'^T,  C_w = sum mu~ Xi
///   Q_t = -w x (w x S + 2 S'),         Q_w = -w x Theta w - 2 (tr(G) w - G^T w)
///   Q_f = sum Xi^T b - K q - D q',     b = -(A mu + 2 w x mu'),  A = w w^T - |w|^2 1
/// and the terms of geometric stiffening (body_stiffening.h). Elastic and damping forces are taken
/// at q_elastic and v_elastic.
BodyTerms calc_body_terms(const BodyModel& model, const BodyState& state, const BodyMotion& motion,
                          const Damping& damping, const BodyWork& work) noexcept;

}  // namespace spoke::space
