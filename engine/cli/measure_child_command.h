#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/compare/child.h"
#include "engine/compare/configuration.h"
#include "models/scenario.h"

namespace spoke::cli {

/// The first word of a command line that asks for measure_child().
inline constexpr std::string_view kMeasureChild = "measure-child";

/// What a child simulates.
struct ChildTask {
  std::string scenario;  ///< file
  Overrides overrides;
  Integration integration;  ///< its method, step and duration replace those of the scenario
  int window = 0;           ///< as SimulationOptions::window
};

/// The command that starts this program as a child that measures a configuration.
compare::Command make_child_command(const ChildTask& task,
                                    const compare::Configuration& configuration);

/// Builds the simulation and runs steps as it is told on standard input, see compare/rounds.h.
/// Ends with its input. The exit status.
int measure_child(const std::vector<std::string>& words);

}  // namespace spoke::cli
