#pragma once

// A first look at a formulation, before it is compared: sizes, steps of a sample, costs of nodes.

#include "bench/compare/comparison.h"

namespace spoke::compare {

/// The scenario lengthened, if need be, to at least `steps` steps of the size it has in force.
/// `simulation` is of that scenario.
Scenario with_steps(const Simulation& simulation, std::int64_t steps);

/// Simulates a formulation serially for a moment: how large it is, how many steps make a sample of
/// `sample_seconds`, what the nodes of its step graph cost. Throws InputError and DivergenceError.
Model probe(const Scenario& scenario, Formulation formulation, double sample_seconds);

}  // namespace spoke::compare
