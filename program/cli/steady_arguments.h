#pragma once

// Options of the commands about steady states: `spoke static`, `modes`, `campbell`, `critical` and
// `linearize`.

#include <optional>
#include <string>
#include <vector>

#include "engine/modes.h"

namespace CLI {
class App;
}

namespace spoke::cli {

/// Options of these commands besides scenario and folder.
struct SteadyArguments {
  SteadyState state;            ///< speeds of hubs [rad/s]; none: the drives'
  std::optional<int> count;     ///< number of modes; none: 10, or as many as there are
  std::vector<double> speeds;   ///< campbell: hub speeds [rad/s]
  std::string of;               ///< critical: what is varied, as in CriticalOptions
  double from = 0.0, to = 0.0;  ///< critical: ends of the range of what is varied
  int points = 21;              ///< critical: values in the range
  std::optional<ModeFrame> frame;
};

/// Adds --speed.
void add_speed(CLI::App& command, SteadyArguments& arguments);
/// Adds --speeds.
void add_speeds(CLI::App& command, SteadyArguments& arguments);
/// Adds --of, --from, --to and --points.
void add_range(CLI::App& command, SteadyArguments& arguments);
/// Adds --count.
void add_count(CLI::App& command, SteadyArguments& arguments);
/// Adds --frame of frames with constant matrices.
void add_constant_frame(CLI::App& command, SteadyArguments& arguments);
/// Adds --frame.
void add_frame(CLI::App& command, SteadyArguments& arguments);

}  // namespace spoke::cli
