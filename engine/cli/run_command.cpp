#include "engine/cli/run_command.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/cli/build_simulation.h"
#include "engine/cli/progress_bar.h"
#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/cli/tip_deflections.h"
#include "engine/cli/trace_files.h"
#include "engine/results.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostTipLines = 6;
constexpr std::int64_t kTracedSteps = 20;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Makes the folder, free of the summary of an earlier run, which would not belong to the rows.
void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) fs::remove(folder / "summary.json", error);
  if (error) {
    throw InputError(folder.string() + ": cannot be the folder of results: " + error.message());
  }
}

/// What is gathered while a simulation runs.
struct Recording {
  Recording(const Simulation& simulation, const fs::path& folder)
      : statistics(simulation.sensor_names().size()),
        tips(simulation),
        due(simulation.scenario().output.interval),
        file(folder / "sensors.csv", simulation.sensor_names()) {}

  SensorStatistics statistics;
  TipDeflections tips;
  OutputTimes due;
  SensorFile file;
  std::optional<StepTrace> trace;
  double writing_time = 0.0;  ///< spent on the file [s]
  double last_row = -1.0;     ///< time of the last row written [s]
};

void write_row(Recording& recording, double t, std::span<const double> values) {
  const auto start = Clock::now();
  recording.file.write_row(t, values);
  recording.last_row = t;
  recording.writing_time += seconds_since(start);
}

void record(double t, std::span<const double> values, Recording& recording) {
  recording.statistics.add(t, values);
  recording.tips.add(t, values);
  if (recording.due.is_due(t)) write_row(recording, t, values);
}

/// Steps to the end or to divergence, if asked for with a trace of the first steps.
RunOutcome integrate(Simulation& simulation, Recording& recording, bool traces,
                     bool show_progress) {
  RunOutcome outcome;
  ProgressBar bar(simulation.scenario().integration.duration, show_progress);
  record(simulation.time(), simulation.sensor_values(), recording);
  recording.writing_time = 0.0;
  const auto start = Clock::now();
  const auto observe = [&](double t, std::span<const double> sensors) {
    record(t, sensors, recording);
    bar.update(t);
  };
  try {
    if (traces)
      recording.trace =
          simulation.trace(std::min(kTracedSteps, simulation.planned_steps()), observe);
    simulation.run_until(simulation.scenario().integration.duration, observe);
  } catch (const DivergenceError& error) {
    outcome.divergence = one_line(error.what());
  }
  outcome.wall_time = seconds_since(start) - recording.writing_time;
  const double last = recording.statistics.last_time();
  if (recording.last_row < last) write_row(recording, last, recording.statistics.final_values());
  recording.file.close();
  return outcome;
}

void print_plan(const Simulation& simulation) {
  print_model(simulation);
  print_line(
      "solved by",
      fmt::format("{}, {}, {} steps of {:.6g} s, {} on {} thread{}",
                  name_of(simulation.options().formulation),
                  name_of(simulation.scenario().integration.method), simulation.planned_steps(),
                  simulation.step_size(), name_of(simulation.options().executor),
                  name_of(simulation.threads()), simulation.threads().total() == 1 ? "" : "s"));
  std::fflush(stdout);
}

std::string describe_energy(const Simulation& simulation, const SensorStatistics& statistics) {
  const auto largest = [&](std::string_view sensor) {
    const auto& names = simulation.sensor_names();
    const auto found = std::find(names.begin(), names.end(), sensor);
    const SensorRange& range =
        statistics.ranges().at(static_cast<std::size_t>(found - names.begin()));
    return std::max(std::abs(range.min), std::abs(range.max));
  };
  const double residual = largest("energy.residual");
  const double kinetic = largest("energy.kinetic");
  std::string text = fmt::format("largest residual {:.3g} J", residual);
  if (kinetic > 0.0)
    text += fmt::format(", {:.2g} of the largest kinetic energy", residual / kinetic);
  return text;
}

void print_result(const Simulation& simulation, const Recording& recording,
                  const RunOutcome& outcome, const fs::path& folder) {
  print_line(
      "took",
      fmt::format("{:.3g} s, {:.3g} s simulated a second, {} evaluations", outcome.wall_time,
                  recording.statistics.last_time() / outcome.wall_time, simulation.evaluations()));
  const bool is_chosen = simulation.options().executor == ExecutorKind::automatic;
  print_line("executor", (is_chosen ? "auto, " : "") + simulation.executor_description());
  const std::vector<std::string> tips = recording.tips.describe();
  for (std::size_t i = 0; i < std::min(tips.size(), kMostTipLines); ++i) {
    print_line(i == 0 ? "tip deflection" : "", tips[i]);
  }
  if (tips.size() > kMostTipLines) {
    print_line("", fmt::format("{} smaller ones: see summary.json", tips.size() - kMostTipLines));
  }
  print_line("energy", describe_energy(simulation, recording.statistics));
  print_line("written", (folder / "sensors.csv").string() + ", summary.json");
}

}  // namespace

int run(const Arguments& arguments) {
  Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  if (arguments.integrator) scenario.integration.method = *arguments.integrator;
  const fs::path folder =
      arguments.out.empty() ? fs::path("results") / scenario.name : fs::path(arguments.out);
  const auto start = Clock::now();
  Simulation simulation = build_simulation(arguments.scenario, scenario, arguments.options);
  spdlog::info("built in {:.3g} s, {} bytes of step data and constants", seconds_since(start),
               simulation.size().memory_bytes);
  const fs::path trace_folder = arguments.trace_out;
  if (!trace_folder.empty()) demand_folder(trace_folder);
  prepare_folder(folder);
  spdlog::info("results go to {}", folder.string());
  Recording recording(simulation, folder);
  if (!arguments.quiet) print_plan(simulation);
  const RunOutcome outcome =
      integrate(simulation, recording, !trace_folder.empty(), !arguments.quiet);
  write_file(folder / "summary.json", make_summary(simulation, recording.statistics, outcome));
  spdlog::info("final state {:#018x}", simulation.state_hash());
  if (!arguments.quiet) print_result(simulation, recording, outcome, folder);
  if (recording.trace)
    write_trace(simulation, std::move(*recording.trace), trace_folder, !arguments.quiet);
  if (outcome.divergence.empty()) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "{}\n", outcome.divergence);
  return 3;
}

}  // namespace spoke::cli
