#pragma once

// Iterations that swing about their limit take a part of a change only.
//
// Forces that are not in Mhat, as the tension of loads and weight between bodies, multiply errors
// by -r, r = beta' h^2 (their stiffness)/(their Mhat), other errors by nearly 0. One plain
// iteration after one that takes the share 1/(1 + r) multiplies errors by x (r - x)/(1 + r), 0 <= x
// <= r: that is r^2/(4 + 4 r) at most, and converges where r is greater than 1.

#include "engine/bodies/table/step_progress.h"
#include "engine/step/integrator/generalized_alpha.h"

namespace spoke {

/// Takes the contraction of a `change` that a pass has found, by that of the pass before, into
/// progress.contraction, if that pass took all of its own.
void learn_contraction(double change, StepProgress& progress) noexcept;

/// Returns the share that the next pass takes, in a step that goes on: where iterations contract
/// slowly, plain and relaxed passes take turns from the third on.
double choose_share(const StepProgress& progress) noexcept;

/// Corrects, as correct() does, by a share of the way to the accelerations `a`; returns the whole
/// change.
Correction correct_relaxed(const GeneralizedAlpha& method, double share, const double* a,
                           CoordinateBlock& block) noexcept;

}  // namespace spoke
