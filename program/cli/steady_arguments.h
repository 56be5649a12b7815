#pragma once

// Options of the commands about steady states: `spoke static`, `modes`, `campbell` and `linearize`.

#include <optional>
#include <vector>

namespace CLI {
class App;
}

namespace spoke::cli {

/// What they ask for besides scenario and folder.
struct SteadyArguments {
  std::optional<double> speed;  ///< [rad/s]; none: that of the drive
  std::optional<int> count;     ///< of modes; none: 10, or as many as there are
  std::vector<double> speeds;   ///< of campbell [rad/s]
};

/// --speed.
void add_speed(CLI::App& command, SteadyArguments& arguments);
/// --speeds.
void add_speeds(CLI::App& command, SteadyArguments& arguments);
/// --count.
void add_count(CLI::App& command, SteadyArguments& arguments);

}  // namespace spoke::cli
