#pragma once

// Iterations that swing about their limit take a part of a change only.
//
// What tension does between bodies is not in Mhat: the iteration multiplies the error of such a
// motion by -r, r = beta' h^2 (its stiffness)/(its Mhat), of others by nearly 0. One plain
// iteration after one that takes the share 1/(1 + r) multiplies errors by x (r - x)/(1 + r), 0 <= x
// <= r: that is r^2/(4 + 4 r) at most, and converges where r is greater than 1.

#include "engine/integrator/generalized_alpha.h"
#include "engine/table/step_progress.h"

namespace spoke {

/// The share that the next pass takes in a step that goes on, after one that found a `change`:
/// plain and relaxed passes take turns from the third on. `progress.change` is that of the pass
/// before; learns `progress.contraction` from the two.
double choose_relaxation(double change, double tolerance, StepProgress& progress) noexcept;

/// correct() by a share of the way to the accelerations `a`; the change told is the whole one.
Correction correct_relaxed(const GeneralizedAlpha& method, double share, const double* a,
                           CoordinateBlock& block) noexcept;

}  // namespace spoke
