// The commands of the program `spoke` and their options, by CLI11.

#include "program/cli/commands.h"

#include <CLI/CLI.hpp>
#include <limits>

#include "engine/checkpoint.h"
#include "models/error.h"
#include "program/cli/help_texts.h"
#include "program/cli/number_option.h"
#include "program/cli/shared_options.h"

namespace spoke::cli {
namespace {

/// Throws CLI::ValidationError unless the executor runs on such threads; neither option alone shows
/// that.
void check_threads(const SimulationOptions& options) {
  try {
    graph::check_threads(options.executor, options.threads);
  } catch (const InputError& error) {
    throw CLI::ValidationError("--threads", error.what());
  }
}

void add_checkpoints(CLI::App& run, Arguments& arguments) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  constexpr double most = std::numeric_limits<double>::max();
  run.add_option_function<std::string>(
         "--checkpoint-every",
         [&](const std::string& text) {
           arguments.checkpoint_every =
               parse_number("--checkpoint-every", text, least, most, "a number above 0 [s]");
         },
         "Write checkpoint.spoke each time so many seconds\nof wall time have passed, and at the "
         "end")
      ->type_name("SECONDS");
  add_path(run, "--resume", arguments.resume,
           "Go on from a checkpoint, with the rows beside it\n"
           "(the same SCENARIO and --set; --out unless given: its folder;\n"
           "--instructions unless given: those of the checkpoint)",
           "FILE");
}

void add_statistics(CLI::App& run, Arguments& arguments) {
  run.add_option_function<std::string>(
         "--statistics-from",
         [&](const std::string& text) {
           arguments.statistics_from =
               parse_number("--statistics-from", text, 0.0, std::numeric_limits<double>::max(),
                            "a number of 0 or more [s]");
         },
         "Collect the statistics in summary.json from this time on, of any\n"
         "model [of models in air: from 0]")
      ->type_name("SECONDS");
}

void add_run(CLI::App& run, Arguments& arguments) {
  add_common(run, arguments);
  add_out(run, arguments, "results/<name of the scenario>");
  add_running(run, arguments);
  add_checkpoints(run, arguments);
  add_statistics(run, arguments);
  run.add_flag_callback(
      "--no-report", [&] { arguments.writes_report = false; }, "Do not write report.html");
  run.add_flag("--vtk", arguments.writes_vtk,
               "Write the deformed model at all output times for ParaView");
  add_path(run, "--trace", arguments.trace_out,
           "Record the first 20 steps, node by node, and write the files of\n"
           "spoke trace to this folder, too",
           "DIR");
  run.add_flag("--quiet", arguments.quiet, "Print nothing but warnings and errors");
  run.footer(std::string(kRunText) + '\n' + kStatusText);
  run.callback([&] { check_threads(arguments.options); });
}

void add_check(CLI::App& check, Arguments& arguments) {
  add_common(check, arguments);
  add_path(check, "--html", arguments.html,
           "Draw the model in this page: bodies, sections, joints, axes, loads", "FILE");
  add_force(check, arguments);
  check.footer(std::string(kCheckText) + '\n' + kStatusText);
}

void add_reduce(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  command.add_flag("--force", arguments.anew, "Make all anew, even if it is in the cache");
  command.footer(std::string(kReduceText) + '\n' + kStatusText);
}

void add_static(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/static");
  add_speed(command, arguments.steady);
  command.footer(std::string(kStaticText) + '\n' + kStatusText);
}

void add_modes(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/modes");
  add_speed(command, arguments.steady);
  add_count(command, arguments.steady);
  add_frame(command, arguments.steady);
  command.footer(std::string(kModesText) + '\n' + kStatusText);
}

void add_campbell(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/campbell");
  add_speeds(command, arguments.steady);
  add_count(command, arguments.steady);
  add_frame(command, arguments.steady);
  command.footer(std::string(kCampbellText) + '\n' + kStatusText);
}

void add_critical(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/critical");
  add_range(command, arguments.steady);
  add_speed(command, arguments.steady);
  add_count(command, arguments.steady);
  add_constant_frame(command, arguments.steady);
  command.footer(std::string(kCriticalText) + '\n' + kStatusText);
}

void add_performance(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/performance");
  add_performance_options(command, arguments.performance);
  command.footer(std::string(kPerformanceText) + '\n' + kStatusText);
}

void add_linearize(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/linear");
  add_speed(command, arguments.steady);
  add_constant_frame(command, arguments.steady);
  command.footer(std::string(kLinearizeText) + '\n' + kStatusText);
}

void add_wind(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_path(command, "--out", arguments.out, "File to write (default: <name of the scenario>.bts)",
           "FILE");
  add_force(command, arguments);
  command.footer(std::string(kWindText) + '\n' + kStatusText);
}

void add_trace(CLI::App& trace, Arguments& arguments) {
  add_common(trace, arguments);
  add_out(trace, arguments, "results/<name of the scenario>/trace");
  add_trace_options(trace, arguments.trace);
  add_running(trace, arguments);
  trace.footer(std::string(kTraceText) + '\n' + kStatusText);
  trace.callback([&] { check_threads(arguments.options); });
}

/// Returns the instructions that a checkpoint was computed with; empty if no run is resumed, or if
/// the file cannot be read, which is reported when the run is resumed.
std::string instructions_of_checkpoint(const Arguments& arguments) {
  if (arguments.resume.empty()) return {};
  try {
    return load_checkpoint(arguments.resume).instructions;
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

std::vector<Command> make_commands() {
  return {
      {.name = "run",
       .summary = "Simulate a scenario and write its results",
       .add_options = add_run,
       .execute = run,
       .instructions_before = instructions_of_checkpoint},
      {.name = "check",
       .summary = "Validate a scenario and print its model",
       .add_options = add_check,
       .execute = check,
       .prints_result = true},
      {.name = "reduce",
       .summary = "Reduce bodies from finite-element meshes to modes",
       .add_options = add_reduce,
       .execute = reduce_solids,
       .prints_result = true},
      {.name = "static",
       .summary = "Find where a model stands in steady rotation, or at rest",
       .add_options = add_static,
       .execute = find_static},
      {.name = "modes",
       .summary = "Find frequencies, damping and shapes of a model's vibrations",
       .add_options = add_modes,
       .execute = find_modes},
      {.name = "campbell",
       .summary = "Follow a model's vibrations over the speed of rotation",
       .add_options = add_campbell,
       .execute = find_campbell},
      {.name = "critical",
       .summary = "Find the speed or load at which an equilibrium becomes unstable",
       .add_options = add_critical,
       .execute = find_critical},
      {.name = "performance",
       .summary = "Find thrust and power of a rotor over wind, tip-speed ratio and pitch",
       .add_options = add_performance,
       .execute = find_performance},
      {.name = "linearize",
       .summary = "Write the state-space matrices of small motions about an equilibrium",
       .add_options = add_linearize,
       .execute = linearize},
      {.name = "wind",
       .summary = "Write a scenario's turbulent wind as a file of TurbSim",
       .add_options = add_wind,
       .execute = write_wind},
      {.name = "study", .summary = kStudySummary},
      {.name = "import", .summary = kImportSummary},
      {.name = "export", .summary = kExportSummary},
      {.name = "fmu", .summary = kFmuSummary},
      {.name = "compare", .summary = kCompareSummary},
      {.name = "predict", .summary = kPredictSummary},
      {.name = "trace",
       .summary = "Record steps, node by node, to look at",
       .add_options = add_trace,
       .execute = trace},
      {.name = "reproduce", .summary = kReproduceSummary},
  };
}

}  // namespace spoke::cli
