#pragma once

// Options of the commands about steady states: `spoke static`, `modes`, `campbell` and `linearize`.

#include <optional>
#include <vector>

namespace CLI {
class App;
}

namespace spoke::cli {

/// Options of these commands besides scenario and folder.
struct SteadyArguments {
  std::optional<double> speed;  ///< hub speed [rad/s]; none: the drive's
  std::optional<int> count;     ///< number of modes; none: 10, or as many as there are
  std::vector<double> speeds;   ///< campbell: hub speeds [rad/s]
};

/// Adds --speed.
void add_speed(CLI::App& command, SteadyArguments& arguments);
/// Adds --speeds.
void add_speeds(CLI::App& command, SteadyArguments& arguments);
/// Adds --count.
void add_count(CLI::App& command, SteadyArguments& arguments);

}  // namespace spoke::cli
