#pragma once

// The options of `spoke trace`.

#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace spoke::cli {

/// What only the command trace asks for.
struct TraceArguments {
  std::int64_t steps = 20;
  double from = 0.0;         ///< [s]
  double buffer_mb = 256.0;  ///< [10^6 bytes]
};

/// Adds --steps, --from and --buffer to the command.
void add_trace_options(CLI::App& command, TraceArguments& arguments);

}  // namespace spoke::cli
