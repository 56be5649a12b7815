#pragma once

// What a command line asks for, of all commands.

#include <optional>
#include <string>
#include <vector>

#include "engine/cli/compare_arguments.h"
#include "engine/cli/predict_arguments.h"
#include "engine/cli/steady_arguments.h"
#include "engine/cli/trace_arguments.h"
#include "engine/simulation.h"
#include "models/scenario.h"

namespace spoke::cli {

/// What the command line asks for.
struct Arguments {
  enum class Command {
    none,  ///< nothing: help or version was asked for and has been printed
    run,
    check,
    compare,
    predict,
    reproduce,
    trace,
    find_static,
    find_modes,
    find_campbell,
    linearize,
    study,
  };
  Command command = Command::none;
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
  CompareArguments compare;
  PredictArguments predict;
  TraceArguments trace;
  SteadyArguments steady;
  std::string trace_out;  ///< of run: folder of a trace; empty: none
  bool quick = false;     ///< of reproduce: few rounds
  std::string study;      ///< of study: file
  bool resumes = false;   ///< of study: goes on from the journal in the folder
};

}  // namespace spoke::cli
