#pragma once

// The options of `spoke predict`.

#include <optional>
#include <vector>

namespace CLI {
class App;
}

namespace spoke::cli {

/// Options of the command predict alone.
struct PredictArguments {
  std::vector<int> threads{1, 2, 4, 8, 16, 32, 64};  ///< numbers of threads, ascending
  int window = 0;                 ///< number of steps; 0: as each executor chooses
  std::vector<int> ranks;         ///< numbers of processes, ascending; empty: not asked for
  std::optional<double> latency;  ///< latency between processes [s]; none: measured or assumed
};

/// Adds --threads, --window, --ranks and --latency to the command.
void add_predict_options(CLI::App& command, PredictArguments& arguments);

}  // namespace spoke::cli
