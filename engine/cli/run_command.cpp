#include "engine/cli/run_command.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "engine/cli/build_simulation.h"
#include "engine/cli/checkpoints.h"
#include "engine/cli/interruption.h"
#include "engine/cli/progress_bar.h"
#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/cli/tip_deflections.h"
#include "engine/results.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostTipLines = 6;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Removes what an earlier run left and does not belong to the rows of this one; the checkpoint
/// that this one resumes from does.
void remove_stale(const fs::path& folder, const fs::path& resumed) {
  std::error_code error;
  fs::remove(folder / "summary.json", error);
  const fs::path checkpoint = folder / "checkpoint.spoke";
  std::error_code none;
  if (!error && (resumed.empty() || !fs::equivalent(resumed, checkpoint, none)))
    fs::remove(checkpoint, error);
  if (error)
    throw InputError(folder.string() + ": cannot be the folder of results: " + error.message());
}

/// What is gathered while a simulation runs.
struct Recording {
  Recording(const Simulation& simulation, const fs::path& folder)
      : statistics(simulation.sensor_names().size()),
        tips(simulation),
        due(simulation.scenario().output.interval),
        file(folder / "sensors.csv", simulation.sensor_names()) {}
  /// Goes on where `before` ended, with its rows in `rows`.
  Recording(const Simulation& simulation, const fs::path& folder, const RunRecord& before,
            const fs::path& rows)
      : statistics(before.ranges, simulation.time()),
        tips(simulation, before.tips),
        due(before.output_interval, before.next_multiple),
        file(folder / "sensors.csv", before.rows, rows),
        wall_time_before(before.wall_time),
        last_row(before.last_row) {}

  SensorStatistics statistics;
  TipDeflections tips;
  OutputTimes due;
  SensorFile file;
  double wall_time_before = 0.0;  ///< of the run that is resumed [s]
  double writing_time = 0.0;      ///< spent on files [s]
  double last_row = -1.0;         ///< time of the last row written [s]; negative: none yet
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

void write_checkpoint(const Simulation& simulation, double wall_time, Recording& recording,
                      Checkpoints& checkpoints) {
  const auto start = Clock::now();
  checkpoints.save(
      simulation,
      {simulation.scenario().output.interval, recording.due.next_multiple(), recording.last_row,
       wall_time, recording.statistics.ranges(), recording.tips.extremes(), recording.file.sync()});
  recording.writing_time += seconds_since(start);
}

std::string describe_interruption(const Simulation& simulation, const Checkpoints& checkpoints) {
  std::string text =
      fmt::format("interrupted by {} at t = {:.6g} s, step {}",
                  name_of_signal(Interruption::signal()), simulation.time(), simulation.steps());
  if (checkpoints.are_wanted())
    text += "; go on with --resume " + one_line(checkpoints.file().string());
  return text;
}

/// Steps to the end, to divergence or to a signal.
RunOutcome integrate(Simulation& simulation, Recording& recording, Checkpoints& checkpoints,
                     bool show_progress) {
  const double duration = simulation.scenario().integration.duration;
  RunOutcome outcome;
  ProgressBar bar(simulation.time(), duration, show_progress);
  if (recording.last_row < 0.0) record(simulation.time(), simulation.sensor_values(), recording);
  recording.writing_time = 0.0;
  const auto start = Clock::now();
  const auto wall_time = [&] {
    return recording.wall_time_before + seconds_since(start) - recording.writing_time;
  };
  const auto observe = [&](double t, std::span<const double> sensors) {
    record(t, sensors, recording);
    bar.update(t);
    if (Interruption::signal() != 0 || checkpoints.is_due()) simulation.stop();
  };
  try {
    while (!simulation.done() && Interruption::signal() == 0) {
      simulation.run_until(duration, observe);
      if (checkpoints.is_due() && !simulation.done())
        write_checkpoint(simulation, wall_time(), recording, checkpoints);
    }
    if (!simulation.done()) outcome.interruption = describe_interruption(simulation, checkpoints);
  } catch (const DivergenceError& error) {
    outcome.divergence = one_line(error.what());
  }
  outcome.wall_time = wall_time();
  // Before the row that only the end of a run has: a longer run goes on without it.
  if (checkpoints.are_wanted() && outcome.divergence.empty())
    write_checkpoint(simulation, outcome.wall_time, recording, checkpoints);
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

fs::path folder_of_results(const Arguments& arguments, const Scenario& scenario) {
  if (!arguments.out.empty()) return arguments.out;
  if (arguments.resume.empty()) return fs::path("results") / scenario.name;
  const fs::path folder = fs::path(arguments.resume).parent_path();
  return folder.empty() ? "." : folder;
}

/// Opens the files of a run, a new one or one that is resumed, and restores its state.
Recording open_recording(const fs::path& folder, const fs::path& resumed, Simulation& simulation) {
  if (resumed.empty()) {
    make_folder(folder);
    return Recording(simulation, folder);
  }
  const Checkpoint checkpoint = resume(resumed, simulation);
  make_folder(folder);
  return Recording(simulation, folder, *checkpoint.record, resumed.parent_path() / "sensors.csv");
}

int exit_status(const RunOutcome& outcome) {
  if (!outcome.divergence.empty()) return 3;
  return outcome.interruption.empty() ? 0 : 128 + Interruption::signal();
}

}  // namespace

int run(const Arguments& arguments) {
  Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  if (arguments.integrator) scenario.integration.method = *arguments.integrator;
  const fs::path folder = folder_of_results(arguments, scenario);
  const auto start = Clock::now();
  Simulation simulation = build_simulation(arguments.scenario, scenario, arguments.options);
  spdlog::info("built in {:.3g} s, {} bytes of step data and constants", seconds_since(start),
               simulation.size().memory_bytes);
  Recording recording = open_recording(folder, arguments.resume, simulation);
  remove_stale(folder, arguments.resume);
  spdlog::info("results go to {}", folder.string());
  Checkpoints checkpoints(folder / "checkpoint.spoke", arguments.checkpoint_every);
  if (!arguments.quiet) print_plan(simulation);
  if (!arguments.quiet && !arguments.resume.empty())
    print_line("resumed", fmt::format("{} at t = {:.6g} s, step {}", one_line(arguments.resume),
                                      simulation.time(), simulation.steps()));
  const Interruption interruption;
  const RunOutcome outcome = integrate(simulation, recording, checkpoints, !arguments.quiet);
  write_file(folder / "summary.json", make_summary(simulation, recording.statistics, outcome));
  spdlog::info("final state {:#018x}", simulation.state_hash());
  if (!arguments.quiet) print_result(simulation, recording, outcome, folder);
  std::fflush(stdout);
  const std::string message = outcome.divergence + outcome.interruption;
  if (!message.empty()) fmt::print(stderr, "{}\n", message);
  return exit_status(outcome);
}

}  // namespace spoke::cli
