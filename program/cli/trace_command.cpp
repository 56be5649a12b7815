// Runs to the time asked for, and records the steps that follow.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "engine/simulation/node_measurement.h"
#include "models/count_text.h"
#include "models/error.h"
#include "program/cli/build_simulation.h"
#include "program/cli/commands.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/standard_streams.h"
#include "program/cli/trace_files.h"
#include "program/trace/files.h"
#include "program/trace/more_threads.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kUsualSteps = 20;

/// Returns how many steps to record. Throws InputError if the scenario lacks the steps that are
/// asked for.
std::int64_t choose_steps(const TraceArguments& asked, const Simulation& simulation) {
  const double step = simulation.step_size();
  const std::int64_t planned = simulation.planned_steps();
  const std::int64_t steps = asked.steps.value_or(std::min(kUsualSteps, planned));
  if (steps > planned)
    throw InputError(
        fmt::format("spoke trace: --steps {}: the scenario has {}, expected at most {}", steps,
                    counted(planned, "step"), planned));
  const double last = static_cast<double>(planned - steps) * step;
  if (asked.from > last + 0.5 * step)
    throw InputError(fmt::format(
        "spoke trace: --from {:.6g}: {} of {:.6g} s {} at {:.6g} s, expected at most {:.6g} s",
        asked.from, counted(planned, "step"), step, planned == 1 ? "ends" : "end",
        static_cast<double>(planned) * step, last));
  return steps;
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

/// Recorded steps and, if the simulation diverged, the reason why they ended early.
struct Traced {
  StepTrace steps;
  std::string divergence;
};

[[noreturn]] void throw_too_small(const TraceArguments& asked, const StepTrace& steps) {
  std::string text = fmt::format("spoke trace: --buffer {:g}: no step fits, expected at least {}",
                                 asked.buffer_mb, megabytes(steps.bytes_of_first));
  if (steps.asked_steps > 1)
    text += fmt::format(", for all {} steps {}", steps.asked_steps, megabytes(steps.bytes_of_all));
  throw InputError(text);
}

Traced record(const TraceArguments& asked, std::int64_t steps, Simulation& simulation) {
  Traced traced;
  TraceOptions options;
  options.buffer_bytes = static_cast<std::size_t>(1e6 * asked.buffer_mb);
  options.unfinished = [&](StepTrace recorded) { traced.steps = std::move(recorded); };
  try {
    traced.steps = simulation.trace(steps, {}, options);
  } catch (const DivergenceError& error) {
    if (traced.steps.steps.empty()) throw;
    traced.divergence = one_line(error.what());
  }
  if (traced.steps.steps.empty()) throw_too_small(asked, traced.steps);
  return traced;
}

/// Simulates the traced steps on other numbers of threads: by the graph that `simulation` runs, for
/// auto in the window that it chooses. To choose one it makes some of the steps that are left.
trace::MoreThreads find_more_threads(const TraceArguments& asked, const Traced& traced,
                                     Simulation& simulation) {
  show_progress("simulating more threads");
  int window_steps = 1;
  try {
    if (traced.divergence.empty()) window_steps = open_window(simulation);
  } catch (const DivergenceError&) {  // behind the traced steps; runs of a pass remain
  }
  auto found = trace::find_more_threads(traced.steps, simulation.run_graph(), window_steps,
                                        asked.more_threads);
  show_progress("");
  return found;
}

}  // namespace

int trace(const Arguments& arguments) {
  Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  if (arguments.integrator) scenario.integration.method = *arguments.integrator;
  const fs::path folder = arguments.out.empty() ? fs::path("results") / scenario.name / "trace"
                                                : fs::path(arguments.out);
  require_folder(folder, trace::file_names());
  Simulation simulation = build_simulation(arguments.scenario, scenario, arguments.options);
  const TraceArguments& asked = arguments.trace;
  const std::int64_t steps = choose_steps(asked, simulation);
  const ResultsFolder taken(folder);
  trace::remove_files(folder);
  run_to(asked.from, simulation);
  Traced traced = record(asked, steps, simulation);
  print_model(simulation);
  trace::MoreThreads more = find_more_threads(asked, traced, simulation);
  write_trace(simulation, std::move(traced.steps), folder, true, std::move(more));
  if (traced.divergence.empty()) return 0;
  print_error(traced.divergence);
  return 3;
}

}  // namespace spoke::cli
