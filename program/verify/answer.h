#pragma once

// Answers of linear models to harmonic inputs.

#include "engine/linearize.h"
#include "program/verify/case.h"

namespace spoke::verify {

/// Returns the amplitude of an output per unit of an input at the frequency `figure.at` [rad/s];
/// `figure.of` names both, "INPUT -> OUTPUT". Throws InputError if there is none of a name.
double read_answer(const LinearSystem& system, const Figure& figure);

}  // namespace spoke::verify
