#pragma once

// What the steps before tell the iteration of the next (generalized_alpha).
//
// A step that begins near its solution, and whose iteration contracts fast, makes its second pass
// only to confirm the first. So a step remembers the contraction that the ones before have seen:
// the first change times that, with a margin, is what it leaves. Predictions go on from the
// accelerations of two or three steps (PassControl::order): smooth motion is foretold better by
// three, vibrations that the step does not resolve and that swing from one step to the next, by
// two; by one, the error is large in what contracts fast, and hides what does not. Every eighth
// step measures the contraction anew. It also predicts by the other order, which is taken if it
// foretells better; each trial of the order that gains nothing doubles the steps to the next, to 64
// at most. All of it is part of the state, so that resumed simulations keep their bits.

#include "engine/bodies/table/step_progress.h"

namespace spoke {

/// Returns the order of the prediction of the next step (PassControl), `highest` at most, 1 to 3.
int choose_order(int highest, const IterationMemory& memory) noexcept;

/// Takes the first change of a step, which tells how good its prediction was.
void learn_order(double first_change, StepProgress& progress) noexcept;

/// Returns the contraction to count with, 0 to 1: the one that this step has seen; after its first
/// pass that of steps before, with a margin; 1: none is known, or it is to be measured.
double foretell_contraction(const StepProgress& progress) noexcept;

/// Ends a step. `is_plain`: its first change was small enough by itself, and nothing was foretold;
/// such steps need no trials.
void remember_step(bool is_plain, StepProgress& progress) noexcept;

/// Ends a restart, whose accelerations are the only ones that the next step knows.
void forget_accelerations(StepProgress& progress) noexcept;

}  // namespace spoke
