#pragma once

// The terms of a body whose directions do not meet: direction by direction, four nodes or elements
// side by side. Their equations stand in body_terms.h; here S = S0 + C_t q, J = J0 + (P + P^T)/2
// with P = sum delta (2 mu0 + m delta)^T, and G = sum mu delta'^T, delta the displacement of a slot
// (docs/formulation.md, section 10).

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

/// Calculates them. Precondition: the body has directions. Undamped: damping adds to `work.rows`.
BodyTerms calc_straight_terms(const BodyModel& model, const BodyState& state,
                              const BodyMotion& motion, const BodyWork& work) noexcept;

}  // namespace spoke::space
