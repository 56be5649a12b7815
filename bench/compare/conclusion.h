#pragma once

// Conclusions of a comparison in plain words.

#include <string>
#include <vector>

#include "bench/compare/comparison.h"

namespace spoke::compare {

/// Returns the conclusions, a part for each subject: doubts about the measurement; for each
/// formulation, which configuration is best and by how much, or that serial is; configurations that
/// were not measured or whose bits differed; the machine and its load.
std::vector<std::string> make_conclusions(const Comparison& comparison);
/// Returns the conclusions as one paragraph.
std::string make_conclusion(const Comparison& comparison);

}  // namespace spoke::compare
