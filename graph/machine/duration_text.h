#pragma once

// Writes times as people read them.

#include <string>

namespace spoke::graph {

/// Returns three digits in a suitable unit: "13.1 us", "2.04 ms", "7.5 s".
std::string duration_text(double seconds);

}  // namespace spoke::graph
