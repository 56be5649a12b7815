#pragma once

// Integration of an orientation: of a free hub, of a spherical joint. Its velocity is an angular
// velocity w, whose integral is no orientation. So three places of a block of coordinates hold the
// rotation vector D by which it has turned since the step's start, Q = Q_n exp(D~) in the child's
// frame or exp(D~) Q_n in the parent's. When a step begins, D is folded into Q_n and is zero again.
//   generalized_alpha: D' = w, to the method's order two; D is a coordinate like others
//   rk4:               the four numbers of exp(D~) are integrated, P' = 1/2 P (0, w) or 1/2 (0, w)
//   P,
//                      and brought back to unit length in every stage
// All else, correct() and restarts too, treats these places as it does any others. The angle about
// an axle is no such orientation: it is a plain coordinate.

#include "engine/bodies/space/rotation_block.h"
#include "engine/step/integrator/method.h"

namespace spoke::space {

/// Returns the orientation Q.
Quaternion calc_orientation(const RotationBlock& rotation) noexcept;

/// Sets D to zero, and leaves the orientation as it is.
void fold(const RotationBlock& rotation) noexcept;

/// Sets the whole block for `stage` of rk4, see advance() of engine/step/integrator/rk4.h.
void advance(const Rk4& method, int stage, const RotationBlock& rotation) noexcept;

/// Predicts the whole block for generalized_alpha.
void predict(const GeneralizedAlpha& method, int order, const RotationBlock& rotation) noexcept;

}  // namespace spoke::space
