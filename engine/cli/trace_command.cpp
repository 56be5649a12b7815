#include "engine/cli/trace_command.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "engine/cli/build_simulation.h"
#include "engine/cli/progress_line.h"
#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/cli/trace_files.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

/// Whether the scenario has the steps that are asked for.
void demand_steps(const TraceArguments& asked, const Simulation& simulation) {
  const double step = simulation.step_size();
  const std::int64_t planned = simulation.planned_steps();
  if (asked.steps > planned)
    throw InputError(
        fmt::format("spoke trace: --steps {}: the scenario has {} steps, expected at most {}",
                    asked.steps, planned, planned));
  const double last = static_cast<double>(planned - asked.steps) * step;
  if (asked.from > last + 0.5 * step)
    throw InputError(fmt::format(
        "spoke trace: --from {:.6g}: {} steps of {:.6g} s end at {:.6g} s, expected at most "
        "{:.6g} s",
        asked.from, planned, step, static_cast<double>(planned) * step, last));
}

void run_to(double time, Simulation& simulation) {
  if (time > 0.0) show_progress(fmt::format("running to {:.6g} s", time));
  try {
    simulation.run_until(time);
  } catch (...) {
    show_progress("");
    throw;
  }
  show_progress("");
}

}  // namespace

int trace(const Arguments& arguments) {
  Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  if (arguments.integrator) scenario.integration.method = *arguments.integrator;
  const fs::path folder = arguments.out.empty() ? fs::path("results") / scenario.name / "trace"
                                                : fs::path(arguments.out);
  demand_folder(folder);
  Simulation simulation = build_simulation(arguments.scenario, scenario, arguments.options);
  const TraceArguments& asked = arguments.trace;
  demand_steps(asked, simulation);
  run_to(asked.from, simulation);
  TraceOptions options;
  options.buffer_bytes = static_cast<std::size_t>(1e6 * asked.buffer_mb);
  StepTrace steps = simulation.trace(asked.steps, {}, options);
  print_model(simulation);
  const bool may_choose =
      simulation.options().executor == ExecutorKind::automatic && simulation.threads().total() > 1;
  if (may_choose && asked.from == 0.0)
    print_line("", "auto has chosen nothing yet: --from TIME lets it do so before");
  write_trace(simulation, std::move(steps), folder, true);
  return 0;
}

}  // namespace spoke::cli
