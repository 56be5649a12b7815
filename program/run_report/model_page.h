#pragma once

// The page of `spoke check --html`: a model, drawn before it is simulated.

#include <string>

#include "models/scenario.h"

namespace spoke::run_report {

/// Returns a self-contained page of the model as it stands at t = 0, undeformed, with its axes,
/// joints, loads and sensors.
std::string make_model_page(const Scenario& scenario);

}  // namespace spoke::run_report
