// The command `run` and its options, by CLI11.

#include <CLI/CLI.hpp>
#include <limits>

#include "engine/checkpoint.h"
#include "models/error.h"
#include "program/cli/commands.h"
#include "program/cli/help_texts.h"
#include "program/cli/number_option.h"
#include "program/cli/shared_options.h"

namespace spoke::cli {
namespace {

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

Command make_run() {
  return {.name = "run",
          .add_options = add_run,
          .execute = run,
          .instructions_before = instructions_of_checkpoint};
}

}  // namespace spoke::cli
