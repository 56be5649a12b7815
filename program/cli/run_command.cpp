// The loop of a run: rows, pictures, checkpoints, traces, and the lines that are printed.

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "engine/output/vtk/vtk_series.h"
#include "engine/results.h"
#include "engine/run_statistics.h"
#include "models/count_text.h"
#include "models/error.h"
#include "program/cli/checkpoints.h"
#include "program/cli/commands.h"
#include "program/cli/file_guard.h"
#include "program/cli/interruption.h"
#include "program/cli/print_loops.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/shared_run.h"
#include "program/cli/standard_streams.h"
#include "program/cli/trace_files.h"
#include "program/run_report/energy_residual.h"
#include "program/run_report/html_file.h"
#include "program/run_report/picture_steps.h"
#include "program/run_report/tip_deflections.h"
#include "program/trace/files.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostTipLines = 6;
constexpr std::int64_t kTracedSteps = 20;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Removes files of an earlier run that do not belong to this run's rows. The checkpoint from which
/// this run resumes stays.
void remove_stale(const fs::path& folder, const Arguments& arguments) {
  const fs::path resumed = arguments.resume;
  std::error_code error;
  for (const char* file : {"summary.json", "report.html"})
    if (!error) fs::remove(folder / file, error);
  const fs::path checkpoint = folder / "checkpoint.spoke";
  std::error_code none;
  if (!error && (resumed.empty() || !fs::equivalent(resumed, checkpoint, none)))
    fs::remove(checkpoint, error);
  if (error)
    throw InputError(folder.string() + ": cannot be the folder of results: " + error.message());
  if (!arguments.writes_vtk) remove_vtk_series(folder / "vtk");
}

/// Everything that is recorded while a simulation runs.
struct Recording {
  Recording(const Simulation& simulation, const Arguments& arguments, const fs::path& folder)
      : statistics(simulation.sensor_names().size()),
        rows(simulation, arguments.statistics_from),
        tips(simulation),
        due(simulation.scenario().output.interval),
        file(folder / "sensors.csv", column_heads(simulation)) {
    open_pictures(simulation, arguments, folder);
  }
  /// Goes on where `before` ended, with its rows in `rows_before`.
  Recording(const Simulation& simulation, const Arguments& arguments, const fs::path& folder,
            const RunRecord& before, const fs::path& rows_before)
      : statistics(before.ranges, simulation.time()),
        rows(simulation, arguments.statistics_from),
        tips(simulation, before.tips),
        due(before.output_interval, before.next_multiple),
        file(folder / "sensors.csv", before.rows, rows_before),
        wall_time_before(before.wall_time),
        last_row(before.last_row) {
    open_pictures(simulation, arguments, folder);
    if (report || !rows.series().empty())
      read_rows(folder / "sensors.csv",
                [this](double t, std::span<const double> values) { add_row(t, values); });
  }

  /// Adds a row to all that is made of rows.
  void add_row(double t, std::span<const double> values) {
    rows.add_row(t, values);
    if (report) report->add_row(t, values);
  }

  SensorStatistics statistics;
  RunStatistics rows;
  run_report::TipDeflections tips;
  OutputTimes due;
  SensorFile file;
  std::optional<run_report::Recorder> report;
  std::optional<VtkSeries> vtk;
  std::optional<StepTrace> trace;
  double wall_time_before = 0.0;  ///< wall time of the run that is resumed [s]
  double writing_time = 0.0;      ///< time spent on files and on recording their later contents [s]
  double last_row = -1.0;         ///< time of the last row written [s]; negative: none yet

 private:
  void open_pictures(const Simulation& simulation, const Arguments& arguments,
                     const fs::path& folder) {
    if (arguments.writes_report) report.emplace(simulation);
    if (arguments.writes_vtk) vtk.emplace(simulation, folder / "vtk");
  }
};

void write_row(Recording& recording, double t, std::span<const double> values) {
  const auto start = Clock::now();
  recording.file.write_row(t, values);
  recording.add_row(t, values);
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

/// Steps at which the simulation stops to record shapes. Files of shapes need all output times, the
/// page a few hundred of them.
struct Stops {
  Stops(const Simulation& simulation, const Recording& recording)
      : pictures(simulation, recording.report ? recording.report->animation().most_frames() : 0),
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

/// Records the shape at the simulation's time, if one is due.
void record_shape(const Simulation& simulation, const Stops& stops, Recording& recording) {
  const auto start = Clock::now();
  const std::int64_t step = simulation.steps();
  if (recording.report && (step == 0 || stops.pictures.next(step - 1) == step))
    recording.report->add_picture(simulation);
  if (recording.vtk) recording.vtk->write(simulation);
  recording.writing_time += seconds_since(start);
}

/// Steps to the end of step `target` as run_until() does, and adds the recorded steps to the trace.
void trace_to(std::int64_t target, const StepObserver& observe, Simulation& simulation,
              Recording& recording) {
  const auto add = [&recording](StepTrace steps) {
    if (recording.trace)
      recording.trace->append(steps);
    else
      recording.trace = std::move(steps);
  };
  TraceOptions options;
  options.unfinished = add;
  add(simulation.trace(target - simulation.steps(), observe, options));
}

/// Steps to the end, to divergence or to a signal.
RunOutcome integrate(Simulation& simulation, Recording& recording, Checkpoints& checkpoints,
                     bool traces, bool show_progress, ranks::Launch& launch) {
  RunOutcome outcome;
  ProgressBar bar(simulation.time(), simulation.scenario().integration.duration, show_progress);
  const Stops stops(simulation, recording);
  const std::int64_t begin = simulation.steps();
  const std::int64_t traced_end =
      traces ? std::min(begin + kTracedSteps, simulation.planned_steps()) : 0;
  if (recording.last_row < 0.0) record(simulation.time(), simulation.sensor_values(), recording);
  record_shape(simulation, stops, recording);
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
      const std::int64_t stop = stops.next(simulation.steps());
      let_advance(stop, launch);
      if (simulation.steps() < traced_end)
        trace_to(std::min(stop, traced_end), observe, simulation, recording);
      else
        simulation.run_until(static_cast<double>(stop) * simulation.step_size(), observe);
      if (simulation.steps() == stop) record_shape(simulation, stops, recording);
      if (checkpoints.is_due() && !simulation.done())
        write_checkpoint(simulation, wall_time(), recording, checkpoints);
    }
    let_go(launch);
    if (!simulation.done()) outcome.interruption = describe_interruption(simulation, checkpoints);
  } catch (const DivergenceError& error) {
    outcome.divergence = one_line(error.what());
  }
  outcome.wall_time = wall_time();
  if (recording.trace) recording.trace->asked_steps = traced_end - begin;  // sum over all its parts
  // Comes before the row that only the end of a run has: a longer run goes on without it.
  if (checkpoints.are_wanted() && outcome.divergence.empty())
    write_checkpoint(simulation, outcome.wall_time, recording, checkpoints);
  const double last = recording.statistics.last_time();
  if (recording.last_row < last) write_row(recording, last, recording.statistics.final_values());
  recording.file.close();
  if (recording.vtk) recording.vtk->close();
  return outcome;
}

std::string describe_energy(const Simulation& simulation, const SensorStatistics& statistics) {
  const run_report::EnergyResidual residual =
      run_report::find_energy_residual(simulation, statistics);
  std::string text = fmt::format("largest residual {:.3g} J", std::abs(residual.value));
  if (residual.share > 0.0)
    text += fmt::format(", {:.2g} of the largest kinetic energy", residual.share);
  if (!residual.explanation.empty()) text += ", " + residual.explanation;
  return text;
}

/// Returns "largest error of a step 4.1e-07, in the deformation of blade 1 / body 4 at 6.2 s; 0.05
/// s would make it 0.001".
std::string describe_accuracy(const Simulation& simulation, const StepAccuracy& accuracy) {
  std::string text = fmt::format("largest error of a step {:.2g}, in {} at {:.6g} s",
                                 accuracy.error, accuracy.place, accuracy.time);
  const double limit = simulation.scenario().limits.step_error;
  if (limit > 0.0) text += fmt::format("; up to {:g} with {:.2g} s", limit, accuracy.step);
  return text;
}

/// Returns the largest residuals of the momenta of a free model on which nothing acts; empty for
/// other models.
std::string describe_momentum(const Simulation& simulation, const SensorStatistics& statistics) {
  const std::vector<std::string>& names = simulation.sensor_names();
  const auto first = std::find(names.begin(), names.end(), "momentum.residual.linear");
  if (first == names.end()) return {};
  const auto k = static_cast<std::size_t>(first - names.begin());
  return fmt::format("largest residual {:.3g} kg m/s, angular {:.3g} kg m^2/s",
                     statistics.ranges()[k].max, statistics.ranges()[k + 1].max);
}

void print_result(const Simulation& simulation, const Recording& recording,
                  const RunOutcome& outcome, const std::string& written) {
  print_line("took", fmt::format("{:.3g} s, {:.3g} s simulated a second, {}", outcome.wall_time,
                                 recording.statistics.last_time() / outcome.wall_time,
                                 counted(simulation.evaluations(), "evaluation")));
  const bool is_chosen = simulation.options().executor == ExecutorKind::automatic;
  print_line("executor", (is_chosen ? "auto, " : "") + simulation.executor_description());
  const std::vector<std::string> tips = recording.tips.describe();
  const char* label = simulation.scenario().space ? "tip moved" : "tip deflection";
  for (std::size_t i = 0; i < std::min(tips.size(), kMostTipLines); ++i) {
    print_line(i == 0 ? label : "", tips[i]);
  }
  if (tips.size() > kMostTipLines) {
    print_line("", counted(static_cast<std::int64_t>(tips.size() - kMostTipLines), "smaller one") +
                       ": see summary.json");
  }
  bool is_first = true;
  for (const EventInRun& event : simulation.events()) {
    print_line(is_first ? "events" : "",
               event.time ? fmt::format("{} at {:.6g} s", event.name, *event.time)
                          : event.name + " did not happen");
    is_first = false;
  }
  print_line("energy", describe_energy(simulation, recording.statistics));
  const std::string momentum = describe_momentum(simulation, recording.statistics);
  if (!momentum.empty()) print_line("momentum", momentum);
  const StepAccuracy accuracy = simulation.step_accuracy();
  if (!accuracy.place.empty()) print_line("step", describe_accuracy(simulation, accuracy));
  print_line("written", written);
}

/// Writes the files that are written at the end. Returns the folder's contents, in one line.
std::string write_results(const Simulation& simulation, const Recording& recording,
                          const RunOutcome& outcome, const fs::path& folder) {
  std::string written = (folder / "sensors.csv").string() + ", summary.json";
  write_file(folder / "summary.json",
             make_summary(simulation, recording.statistics, outcome, recording.rows));
  if (recording.report) {
    write_file(folder / "report.html", run_report::make_html(simulation, recording.statistics,
                                                             outcome, recording.tips.summarise(),
                                                             *recording.report, recording.rows));
    written += ", report.html";
  }
  if (recording.vtk)
    written += fmt::format(", vtk ({})",
                           counted(static_cast<std::int64_t>(recording.vtk->size()), "time"));
  return written;
}

/// Throws InputError if a file could not be written, while the files of an earlier run are still
/// there.
void require_results(const Arguments& arguments, const fs::path& folder) {
  if (!arguments.trace_out.empty()) require_folder(arguments.trace_out, trace::file_names());
  if (arguments.writes_vtk) require_folder(folder / "vtk");
  require_places(folder / "vtk", find_vtk_series(folder / "vtk"));  // of an earlier run
  std::vector<std::string> files = {"summary.json", "report.html"};
  // A run goes on with its own rows and checkpoint, which are looked at when they are read.
  const fs::path resumed = arguments.resume;
  std::error_code none;
  if (resumed.empty() ||
      !fs::equivalent(resumed.parent_path() / "sensors.csv", folder / "sensors.csv", none))
    files.emplace_back("sensors.csv");
  if (resumed.empty() || !fs::equivalent(resumed, folder / "checkpoint.spoke", none))
    files.emplace_back("checkpoint.spoke");
  require_folder(folder, files);
}

fs::path folder_of_results(const Arguments& arguments, const Scenario& scenario) {
  if (!arguments.out.empty()) return arguments.out;
  if (arguments.resume.empty()) return fs::path("results") / scenario.name;
  const fs::path folder = fs::path(arguments.resume).parent_path();
  return folder.empty() ? "." : folder;
}

/// Whether a trace is wanted in a folder other than that of the results.
bool has_own_folder(const fs::path& trace_folder, const fs::path& folder) {
  std::error_code error;
  return !trace_folder.empty() && !fs::equivalent(trace_folder, folder, error);
}

int exit_status(const RunOutcome& outcome) {
  if (!outcome.divergence.empty()) return 3;
  return outcome.interruption.empty() ? 0 : 128 + Interruption::signal();
}

/// A run before its first step. The constructor writes nothing yet, but takes the folders.
struct Prepared {
  Prepared(const Arguments& arguments, Exchange* exchange)
      : scenario(read_run(arguments)),
        folder(folder_of_results(arguments, scenario)),
        simulation(build_timed(arguments, exchange)) {
    require_results(arguments, folder);
    taken.emplace(folder);
    const fs::path trace_folder = arguments.trace_out;
    if (has_own_folder(trace_folder, folder)) taken_for_trace.emplace(trace_folder);
    if (!arguments.resume.empty()) resumed = resume(arguments.resume, simulation);
    if (arguments.checkpoint_every) simulation.save();  // refused now, not when it is due
  }

  /// Opens the files of the run, whether it is new or resumed.
  void open(const Arguments& arguments) {
    const fs::path rows = fs::path(arguments.resume).parent_path() / "sensors.csv";
    if (resumed)
      recording.emplace(simulation, arguments, folder, *resumed->record, rows);
    else
      recording.emplace(simulation, arguments, folder);
    remove_stale(folder, arguments);
    if (!arguments.trace_out.empty()) trace::remove_files(arguments.trace_out);
    spdlog::info("results go to {}", folder.string());
  }

  Scenario scenario;
  fs::path folder;
  Simulation simulation;
  std::optional<ResultsFolder> taken, taken_for_trace;
  std::optional<Checkpoint> resumed;
  std::optional<Recording> recording;

 private:
  Simulation build_timed(const Arguments& arguments, Exchange* exchange) const {
    const auto start = Clock::now();
    Simulation built = build_run(arguments, scenario, exchange);
    spdlog::info("built in {:.3g} s, about {} bytes of data and step graph", seconds_since(start),
                 built.size().memory_bytes);
    return built;
  }
};

/// Makes the steps and writes the results. Returns the exit status.
int complete(Prepared& run, const Arguments& arguments, ranks::Launch& launch) {
  Simulation& simulation = run.simulation;
  const fs::path trace_folder = arguments.trace_out;
  Checkpoints checkpoints(run.folder / "checkpoint.spoke", arguments.checkpoint_every);
  if (!arguments.quiet) print_plan(simulation, launch.count());
  if (!arguments.quiet && arguments.resume.empty()) print_moved_joints(simulation);
  if (!arguments.quiet && !arguments.resume.empty())
    print_line("resumed", fmt::format("{} at t = {:.6g} s, step {}", one_line(arguments.resume),
                                      simulation.time(), simulation.steps()));
  if (run.resumed) warn_of_version(arguments.resume, *run.resumed);
  warn_of_oddities(arguments.scenario, run.scenario);
  const Interruption interruption;
  const RunOutcome outcome = integrate(simulation, *run.recording, checkpoints,
                                       !trace_folder.empty(), !arguments.quiet, launch);
  const std::string written = write_results(simulation, *run.recording, outcome, run.folder);
  spdlog::info("final state {:#018x}", simulation.state_hash());
  if (!arguments.quiet) print_result(simulation, *run.recording, outcome, written);
  if (!trace_folder.empty())
    write_trace_of_run(simulation, std::move(run.recording->trace), trace_folder, !arguments.quiet);
  for (const Warning& warning : simulation.warnings()) print_error("warning: " + warning.text);
  const std::string message = outcome.divergence + outcome.interruption;
  if (!message.empty()) print_error(message);
  return exit_status(outcome);
}

}  // namespace

int run(const Arguments& arguments) {
  require_enough(arguments);
  ranks::Launch launch;
  if (!launch.is_first()) return follow(arguments, launch);
  const std::unique_ptr<Exchange> exchange = launch.make_exchange();
  std::optional<Prepared> prepared;
  try {
    if (exchange && !arguments.trace_out.empty())
      throw InputError("--trace: several processes make the run together, expected one");
    prepared.emplace(arguments, exchange.get());
  } catch (...) {
    give_up(launch);
    throw;
  }
  require_same(arguments, prepared->simulation, launch);
  try {
    prepared->open(arguments);
  } catch (...) {
    let_go(launch);
    throw;
  }
  return complete(*prepared, arguments, launch);
}

}  // namespace spoke::cli
