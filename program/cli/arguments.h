#pragma once

// Arguments of a command line. Commands that are programs of their own keep their own options in a
// structure beside these.

#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/scenario.h"
#include "program/cli/performance_arguments.h"
#include "program/cli/steady_arguments.h"
#include "program/cli/trace_arguments.h"

namespace spoke::cli {

/// Values of the options on the command line.
struct Arguments {
  std::string scenario;  ///< scenario file; new: its name
  Overrides overrides;
  std::string out;                    ///< folder of the results; empty: named after the scenario
  std::string resume;                 ///< run: checkpoint to resume from; empty: start at t = 0
  bool prints_json = false;           ///< schema: the keys as a JSON schema
  bool prints_markdown = false;       ///< schema: the keys as tables in Markdown
  std::string kind;                   ///< new: kind of scenario
  std::string key;                    ///< help: key of scenarios
  std::string html;                   ///< check: file for the model's page; empty: none
  bool replaces_other_kinds = false;  ///< --force of commands that write files
  bool anew = false;                  ///< reduce: makes all anew
  std::optional<double> checkpoint_every;  ///< run: wall time between checkpoints [s]
  std::optional<double> statistics_from;   ///< run: first row of the statistics [s]
  std::optional<IntegrationMethod> integrator;
  SimulationOptions options;
  std::string instructions = "auto";  ///< "auto", "avx2" or "baseline"
  bool quiet = false;
  bool writes_report = true;  ///< run: writes report.html
  bool writes_vtk = false;    ///< run: writes files for ParaView
  int verbosity = 0;          ///< number of -v
  TraceArguments trace;
  SteadyArguments steady;
  PerformanceArguments performance;
  std::string trace_out;  ///< run: folder for a trace; empty: none
};

}  // namespace spoke::cli
