#pragma once

// The options of `spoke compare`.

#include "bench/compare/configuration.h"

namespace CLI {
class App;
}

namespace spoke::cli {

/// Options of the command compare alone.
struct CompareArguments {
  compare::Axes axes;
  int rounds = 20;
};

/// Adds --executors, --threads, --formulations, --wait, --spin, --bind and --repeat to the command.
void add_compare_options(CLI::App& command, CompareArguments& arguments);

}  // namespace spoke::cli
