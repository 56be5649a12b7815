#pragma once

// The page of `spoke check --html`: a model, drawn before it is simulated.

#include <string>

#include "engine/simulation.h"

namespace spoke::run_report {

/// Returns a self-contained page of the model as it stands at t = 0, undeformed, with its axes,
/// joints, loops, loads and sensors. The simulation must be at its start.
std::string make_model_page(const Simulation& simulation);

}  // namespace spoke::run_report
