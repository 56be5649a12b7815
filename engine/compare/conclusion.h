#pragma once

#include <string>

#include "engine/compare/comparison.h"

namespace spoke::compare {

/// A time for people: "13.1 us", "2.04 ms".
std::string duration_text(double seconds);

/// One paragraph in plain words: per formulation which configuration is best and by how much, or
/// that serial is; what was not measured or differed; the machine, its load, and what to distrust.
std::string make_conclusion(const Comparison& comparison);

}  // namespace spoke::compare
