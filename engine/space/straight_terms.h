#pragma once

// The terms of a body whose directions do not meet: direction by direction, four nodes or elements
// side by side. What they are is said in body_terms.h.

#include "engine/space/body_data.h"

namespace spoke::space {

/// Precondition: the body has directions. Undamped: damping adds to `work.rows`.
BodyTerms calc_straight_terms(const BodyModel& model, const BodyState& state,
                              const BodyMotion& motion, const BodyWork& work) noexcept;

}  // namespace spoke::space
