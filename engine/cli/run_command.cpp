#include "engine/cli/run_command.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "engine/cli/build_simulation.h"
#include "engine/cli/progress_bar.h"
#include "engine/cli/report.h"
#include "engine/cli/tip_deflections.h"
#include "engine/results.h"
#include "engine/run_report/html_file.h"
#include "engine/run_report/picture_steps.h"
#include "engine/vtk_series.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostTipLines = 6;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Makes the folder, free of what an earlier run left that would not belong to the rows.
void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (const char* file : {"summary.json", "report.html"})
    if (!error) fs::remove(folder / file, error);
  if (error) {
    throw InputError(folder.string() + ": cannot be the folder of results: " + error.message());
  }
  remove_vtk_series(folder / "vtk");
}

/// What is gathered while a simulation runs.
struct Recording {
  Recording(const Simulation& simulation, const Arguments& arguments, const fs::path& folder)
      : statistics(simulation.sensor_names().size()),
        tips(simulation),
        due(simulation.scenario().output.interval),
        file(folder / "sensors.csv", simulation.sensor_names()) {
    if (arguments.writes_report) report.emplace(simulation);
    if (arguments.writes_vtk) vtk.emplace(folder / "vtk");
  }

  SensorStatistics statistics;
  TipDeflections tips;
  OutputTimes due;
  SensorFile file;
  std::optional<run_report::Recorder> report;
  std::optional<VtkSeries> vtk;
  double writing_time = 0.0;  ///< spent on files, and on what goes into them later [s]
  double last_row = -1.0;     ///< time of the last row written [s]
};

void write_row(Recording& recording, double t, std::span<const double> values) {
  const auto start = Clock::now();
  recording.file.write_row(t, values);
  if (recording.report) recording.report->add_row(t, values);
  recording.last_row = t;
  recording.writing_time += seconds_since(start);
}

void record(double t, std::span<const double> values, Recording& recording) {
  recording.statistics.add(t, values);
  recording.tips.add(t, values);
  if (recording.due.is_due(t)) write_row(recording, t, values);
}

/// The steps between which the simulation runs through. Files of shapes want all output times, the
/// page a few hundred of them.
struct Stops {
  Stops(const Simulation& simulation, const Recording& recording)
      : pictures(simulation, recording.report ? recording.report->film().most_frames() : 0),
        outputs(simulation, 0),
        has_pictures(recording.report),
        has_outputs(recording.vtk),
        end(simulation.planned_steps()) {}

  std::int64_t next(std::int64_t step) const {
    if (has_outputs) return outputs.next(step);
    return has_pictures ? pictures.next(step) : end;
  }

  run_report::PictureSteps pictures, outputs;
  bool has_pictures, has_outputs;
  std::int64_t end;
};

/// Records the shape at the simulation's time, where it is due.
void record_shape(const Simulation& simulation, const Stops& stops, Recording& recording) {
  const auto start = Clock::now();
  const std::int64_t step = simulation.steps();
  if (recording.report && (step == 0 || stops.pictures.next(step - 1) == step))
    recording.report->add_picture(simulation);
  if (recording.vtk) recording.vtk->write(simulation);
  recording.writing_time += seconds_since(start);
}

/// Steps to the end or to divergence.
RunOutcome integrate(Simulation& simulation, Recording& recording, bool show_progress) {
  RunOutcome outcome;
  ProgressBar bar(simulation.scenario().integration.duration, show_progress);
  const Stops stops(simulation, recording);
  const auto observe = [&](double t, std::span<const double> sensors) {
    record(t, sensors, recording);
    bar.update(t);
  };
  record(simulation.time(), simulation.sensor_values(), recording);
  record_shape(simulation, stops, recording);
  recording.writing_time = 0.0;
  const auto start = Clock::now();
  try {
    while (!simulation.done()) {
      const std::int64_t stop = stops.next(simulation.steps());
      simulation.run_until(static_cast<double>(stop) * simulation.step_size(), observe);
      record_shape(simulation, stops, recording);
    }
  } catch (const DivergenceError& error) {
    outcome.divergence = one_line(error.what());
  }
  outcome.wall_time = seconds_since(start) - recording.writing_time;
  const double last = recording.statistics.last_time();
  if (recording.last_row < last) write_row(recording, last, recording.statistics.final_values());
  recording.file.close();
  if (recording.vtk) recording.vtk->close();
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
                  const RunOutcome& outcome, const std::string& written) {
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
  print_line("written", written);
}

/// Writes the files that are written at the end. What is in the folder then, in one line.
std::string write_results(const Simulation& simulation, const Recording& recording,
                          const RunOutcome& outcome, const fs::path& folder) {
  std::string written = (folder / "sensors.csv").string() + ", summary.json";
  write_file(folder / "summary.json", make_summary(simulation, recording.statistics, outcome));
  if (recording.report) {
    write_file(folder / "report.html",
               run_report::make_html(simulation, recording.statistics, outcome,
                                     recording.tips.describe(), *recording.report));
    written += ", report.html";
  }
  if (recording.vtk) written += fmt::format(", vtk ({} times)", recording.vtk->size());
  return written;
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
  prepare_folder(folder);
  spdlog::info("results go to {}", folder.string());
  Recording recording(simulation, arguments, folder);
  if (!arguments.quiet) print_plan(simulation);
  const RunOutcome outcome = integrate(simulation, recording, !arguments.quiet);
  const std::string written = write_results(simulation, recording, outcome, folder);
  spdlog::info("final state {:#018x}", simulation.state_hash());
  if (!arguments.quiet) print_result(simulation, recording, outcome, written);
  if (outcome.divergence.empty()) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "{}\n", outcome.divergence);
  return 3;
}

}  // namespace spoke::cli
