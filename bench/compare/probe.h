#pragma once

// A short run of a formulation before it is compared: sizes, steps of a sample, costs of nodes.

#include "bench/compare/comparison.h"

namespace spoke::compare {

/// Returns the scenario of `simulation`, lengthened if need be to at least `steps` steps of its
/// step size.
Scenario with_steps(const Simulation& simulation, std::int64_t steps);

/// Simulates a formulation serially for a moment. Returns its size, the number of steps that make a
/// sample of `sample_seconds`, and the costs of its step graph's nodes. Throws InputError and
/// DivergenceError.
Model probe(const Scenario& scenario, Formulation formulation, double sample_seconds);

}  // namespace spoke::compare
