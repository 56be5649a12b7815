#pragma once

// The options of `spoke trace`.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace spoke::cli {

/// Options of the command trace alone.
struct TraceArguments {
  std::optional<std::int64_t> steps;  ///< none: 20, or all if there are fewer
  double from = 0.0;                  ///< simulated time at which recording starts [s]
  double buffer_mb = 256.0;           ///< size of the buffer [10^6 bytes]
  /// Numbers of threads on which the steps are simulated, ascending.
  std::vector<int> more_threads = {1, 2, 4, 8, 16, 32, 64};
};

/// Adds --steps, --from, --buffer and --more-threads to the command.
void add_trace_options(CLI::App& command, TraceArguments& arguments);

}  // namespace spoke::cli
