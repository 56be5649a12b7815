#pragma once

// Computes the figures of a case by the library.

#include <string>
#include <vector>

#include "program/verify/case.h"

namespace spoke::verify {

/// Makes the analysis of a case and returns the values of its figures, in their units and times
/// their factors, in their order. Serial. Throws InputError, also for a quantity that the analysis
/// does not have or a mode that was not found, and DivergenceError.
std::vector<double> evaluate(const Case& one, const Scenario& scenario);

}  // namespace spoke::verify
