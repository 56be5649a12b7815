#pragma once

// Figures of runs.

#include <vector>

#include "program/verify/case.h"

namespace spoke::verify {

/// Runs a scenario to its end and returns the figures, of sensors, in SI units. Throws InputError
/// and DivergenceError.
std::vector<double> measure_run(const Case& one, const Scenario& scenario);

}  // namespace spoke::verify
