#pragma once

// The options of `spoke predict`.

#include <vector>

namespace CLI {
class App;
}

namespace spoke::cli {

/// What only the command predict asks for.
struct PredictArguments {
  std::vector<int> threads{1, 2, 4, 8, 16, 32, 64};  ///< ascending
  int window = 0;                                    ///< steps; 0: as each executor chooses
};

/// Adds --threads and --window to the command.
void add_predict_options(CLI::App& command, PredictArguments& arguments);

}  // namespace spoke::cli
