#pragma once

// A line on the terminal that says what the benchmarks are doing.

#include <string>

namespace spoke::bench {

/// Shows on stderr what is going on, in place of what was shown before; an empty text clears the
/// line. Only on a terminal.
void show_progress(const std::string& text);

}  // namespace spoke::bench
