#pragma once

// The options of `spoke trace`.

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace spoke::cli {

/// What only the command trace asks for.
struct TraceArguments {
  std::optional<std::int64_t> steps;  ///< unless given: 20, or all that there are
  double from = 0.0;                  ///< [s]
  double buffer_mb = 256.0;           ///< [10^6 bytes]
};

/// Adds --steps, --from and --buffer to the command.
void add_trace_options(CLI::App& command, TraceArguments& arguments);

}  // namespace spoke::cli
