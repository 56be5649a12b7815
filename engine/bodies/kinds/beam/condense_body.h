#pragma once

// Elimination of a spatial body's deformation, (P 11) without an inverse, and its recovery, (P 7).
//
// With Mhat = L L^T factorised once and half solutions y = L^-1 (.) of C^T, Q_f and the handles'
// E^T (docs/formulation.md, section 10):
//   C W = y_C^T y_C,   C z = y_C^T y_Q,   E W = y_E^T y_C,   E z = y_E^T y_Q
//   S_R = M_RR - C W,  p = Q - C z,       X_h = J_h - E_h W,
//   P_ab = E_a Mhat^-1 E_b^T + X_a S_R^-1 X_b^T,   a_h = b_h + E_h z + X_h S_R^-1 p
//   X = S_R^-1 (p + sum X_h^T f_h),   L^T q'' = y_Q - y_C X + sum y_E,h f_h

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

/// Condenses a body that turns at w to its multi-port. Reads the handles of `work`, and the rows,
/// which its terms have set and loads may have added to; sets `half`, `condensed` and `port`.
void condense_body(const BodyModel& model, const BodyTerms& terms, const Angular& w, bool implicit,
                   BodyWork& work) noexcept;

/// Calculates the acceleration X of the frame, and that of the deformation into the flex vector
/// `a`, from the wrenches on all handles, the inboard one first.
Twist recover_body(const BodyModel& model, const Twist* wrenches, bool implicit,
                   const BodyWork& work, double* a) noexcept;

}  // namespace spoke::space
