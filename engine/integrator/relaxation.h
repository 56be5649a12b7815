#pragma once

// Iterations that swing about their limit take a part of a change only.
//
// What is not in Mhat, as the tension of loads and weight between bodies, multiplies errors by -r,
// r = beta' h^2 (its stiffness)/(its Mhat), of others by nearly 0. One plain iteration after one
// that takes the share 1/(1 + r) multiplies errors by x (r - x)/(1 + r), 0 <= x <= r: that is
// r^2/(4 + 4 r) at most, and converges where r is greater than 1.

#include "engine/integrator/generalized_alpha.h"
#include "engine/table/step_progress.h"

namespace spoke {

/// After a pass that found a `change`: takes into progress.contraction by how much it is greater
/// than that of the pass before, if that one took all of its own.
void learn_contraction(double change, StepProgress& progress) noexcept;

/// The share that the next pass takes, in a step that goes on: of iterations that contract slowly,
/// plain and relaxed passes take turns from the third on.
double choose_share(const StepProgress& progress) noexcept;

/// correct() by a share of the way to the accelerations `a`; the change told is the whole one.
Correction correct_relaxed(const GeneralizedAlpha& method, double share, const double* a,
                           CoordinateBlock& block) noexcept;

}  // namespace spoke
