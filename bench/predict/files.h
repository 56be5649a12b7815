#pragma once

// predict.json, predict.csv and predict.html; docs/predict.md documents every field.

#include <string>

#include "bench/predict/prediction.h"

namespace spoke::predict {

/// Returns everything: scenario, machine, calibrated costs, and all points.
std::string make_json(const Prediction& prediction);
/// Returns a row for each executor and number of threads.
std::string make_csv(const Prediction& prediction);
/// Returns conclusion, chart and table as a page.
std::string make_html(const Prediction& prediction);

}  // namespace spoke::predict
