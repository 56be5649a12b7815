#pragma once

// What a command line asks for. Commands that are programs of their own keep what they alone ask
// for beside it.

#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/scenario.h"
#include "program/cli/steady_arguments.h"
#include "program/cli/trace_arguments.h"

namespace spoke::cli {

/// What the command line asks for.
struct Arguments {
  std::string scenario;  ///< file
  Overrides overrides;
  std::string out;     ///< folder of the results; empty: named after the scenario
  std::string resume;  ///< of run: checkpoint to go on from; empty: start at t = 0
  std::string html;    ///< of check: page of the model; empty: none
  std::optional<double> checkpoint_every;  ///< of run [s of wall time]
  std::optional<IntegrationMethod> integrator;
  SimulationOptions options;
  std::string instructions = "auto";  ///< or "avx2", "baseline"
  bool quiet = false;
  bool writes_report = true;  ///< of run: report.html
  bool writes_vtk = false;    ///< of run: files for ParaView
  int verbosity = 0;          ///< number of -v
  TraceArguments trace;
  SteadyArguments steady;
  std::string trace_out;  ///< of run: folder of a trace; empty: none
};

}  // namespace spoke::cli
