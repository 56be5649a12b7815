#pragma once

// Conclusions of a prediction in plain words.

#include <string>
#include <vector>

#include "bench/predict/prediction.h"

namespace spoke::predict {

/// Returns the conclusions, a part for each subject: doubts about the measurement; bounds by work
/// and span; the number of threads beyond which more do not pay; where openmp_levels is as good as
/// the graph; differences between predicted and measured times; executors that were left out.
std::vector<std::string> make_conclusions(const Prediction& prediction);
/// Returns the conclusions as one paragraph.
std::string make_conclusion(const Prediction& prediction);

}  // namespace spoke::predict
