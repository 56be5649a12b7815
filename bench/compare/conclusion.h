#pragma once

// What a comparison says in plain words.

#include <string>
#include <vector>

#include "bench/compare/comparison.h"

namespace spoke::compare {

/// What is to be said in plain words, a part for each matter: what makes the rest doubtful; per
/// formulation which configuration is best and by how much, or that serial is; what was not
/// measured or differed; the machine and its load.
std::vector<std::string> make_conclusions(const Comparison& comparison);
/// The same as one paragraph.
std::string make_conclusion(const Comparison& comparison);

}  // namespace spoke::compare
