#pragma once

// A line on the terminal about the progress of the benchmarks.

#include <string>
#include <vector>

#include "bench/compare/interleaved.h"

namespace spoke::bench {

/// Shows a text on stderr, in place of the one before; an empty text clears the line. Only on a
/// terminal.
void show_progress(const std::string& text);

/// Times alternatives in turns, and shows that.
inline std::vector<Timing> measure(const std::vector<Alternative>& alternatives,
                                   const Effort& effort) {
  return measure(alternatives, effort, show_progress);
}

}  // namespace spoke::bench
