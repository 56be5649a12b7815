#pragma once

// Times as people read them.

#include <string>

namespace spoke::graph {

/// Three digits in the unit that suits them: "13.1 us", "2.04 ms", "7.5 s".
std::string duration_text(double seconds);

}  // namespace spoke::graph
