#pragma once

// The options of `spoke trace`.

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace spoke::cli {

/// Options of the command trace alone.
struct TraceArguments {
  std::optional<std::int64_t> steps;  ///< none: 20, or all if there are fewer
  double from = 0.0;                  ///< simulated time at which recording starts [s]
  double buffer_mb = 256.0;           ///< size of the buffer [10^6 bytes]
};

/// Adds --steps, --from and --buffer to the command.
void add_trace_options(CLI::App& command, TraceArguments& arguments);

}  // namespace spoke::cli
