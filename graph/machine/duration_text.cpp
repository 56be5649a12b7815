// Writes times as people read them.

#include "graph/machine/duration_text.h"

#include <array>
#include <cstdio>

namespace spoke::graph {

std::string duration_text(double seconds) {
  std::array<char, 32> text;
  const auto print = [&](const char* format, double value) {
    std::snprintf(text.data(), text.size(), format, value);
    return std::string(text.data());
  };
  if (seconds < 1e-3) return print("%.3g us", seconds * 1e6);
  if (seconds < 1.0) return print("%.3g ms", seconds * 1e3);
  return print(seconds < 999.5 ? "%.3g s" : "%.0f s", seconds);
}

}  // namespace spoke::graph
