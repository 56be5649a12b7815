#pragma once

// A line on the terminal that says what the benchmarks are doing.

#include <string>
#include <vector>

#include "engine/compare/interleaved.h"

namespace spoke::bench {

/// Shows on stderr what is going on, in place of what was shown before; an empty text clears the
/// line. Only on a terminal.
void show_progress(const std::string& text);

/// Times alternatives in turns, and shows that.
inline std::vector<Timing> measure(const std::vector<Alternative>& alternatives,
                                   const Effort& effort) {
  return measure(alternatives, effort, show_progress);
}

}  // namespace spoke::bench
