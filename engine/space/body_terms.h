#pragma once

// The terms of a spatial body's equation of motion at a state, (P 3) in space.

#include "engine/space/body_data.h"
#include "models/rotor.h"

namespace spoke::space {

/// Calculates the state-dependent mass terms and the right-hand side of a body, without loads: the
/// terms, and the rows C_w^T and Q_f of `work`. Elastic and damping forces are taken at q_elastic
/// and v_elastic.
BodyTerms calc_body_terms(const BodyModel& model, const BodyState& state, const BodyMotion& motion,
                          const Damping& damping, const BodyWork& work) noexcept;

}  // namespace spoke::space
