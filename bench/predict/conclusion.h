#pragma once

// What a prediction says in plain words.

#include <string>
#include <vector>

#include "bench/predict/prediction.h"

namespace spoke::predict {

/// What is to be said in plain words: what makes the rest doubtful; what work and span allow; where
/// more threads stop paying; where openmp_levels is as good as the graph; how far predictions were
/// from what was measured; which executors were left out.
std::vector<std::string> make_conclusions(const Prediction& prediction);
/// The same as one paragraph.
std::string make_conclusion(const Prediction& prediction);

}  // namespace spoke::predict
