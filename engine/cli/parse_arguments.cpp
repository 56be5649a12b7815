// The commands and their options, by CLI11.

#include "engine/cli/parse_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>

#include "engine/cli/help_texts.h"
#include "engine/cli/number_option.h"
#include "engine/cli/shared_options.h"
#include "engine/cli/standard_streams.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

constexpr const char* kCommands =
    "run, check, static, modes, campbell, linearize, study, compare, predict, trace or reproduce";

/// Whether the executor runs on such threads, of which one option says nothing of the other.
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

void add_run(CLI::App& program, Arguments& arguments) {
  CLI::App& run = *program.add_subcommand("run", "Simulate a scenario and write its results");
  add_common(run, arguments);
  add_out(run, arguments, "results/<name of the scenario>");
  add_running(run, arguments);
  add_checkpoints(run, arguments);
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
  run.callback([&] {
    arguments.command = Arguments::Command::run;
    check_threads(arguments.options);
  });
}

void add_check(CLI::App& program, Arguments& arguments) {
  CLI::App& check = *program.add_subcommand("check", "Validate a scenario and print its model");
  add_common(check, arguments);
  add_path(check, "--html", arguments.html,
           "Draw the model in this page: bodies, sections, joints, axes, loads", "FILE");
  check.footer(std::string(kCheckText) + '\n' + kStatusText);
  check.callback([&] { arguments.command = Arguments::Command::check; });
}

void add_static(CLI::App& program, Arguments& arguments) {
  CLI::App& command =
      *program.add_subcommand("static", "Find where a model stands in steady rotation, or at rest");
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/static");
  add_speed(command, arguments.steady);
  command.footer(std::string(kStaticText) + '\n' + kStatusText);
  command.callback([&] { arguments.command = Arguments::Command::find_static; });
}

void add_modes(CLI::App& program, Arguments& arguments) {
  CLI::App& command = *program.add_subcommand(
      "modes", "Find frequencies, damping and shapes of a model's vibrations");
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/modes");
  add_speed(command, arguments.steady);
  add_count(command, arguments.steady);
  command.footer(std::string(kModesText) + '\n' + kStatusText);
  command.callback([&] { arguments.command = Arguments::Command::find_modes; });
}

void add_campbell(CLI::App& program, Arguments& arguments) {
  CLI::App& command =
      *program.add_subcommand("campbell", "Follow a model's vibrations over the speed of rotation");
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/campbell");
  add_speeds(command, arguments.steady);
  add_count(command, arguments.steady);
  command.footer(std::string(kCampbellText) + '\n' + kStatusText);
  command.callback([&] { arguments.command = Arguments::Command::find_campbell; });
}

void add_linearize(CLI::App& program, Arguments& arguments) {
  CLI::App& command = *program.add_subcommand(
      "linearize", "Write the state-space matrices of small motions about an equilibrium");
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/linear");
  add_speed(command, arguments.steady);
  command.footer(std::string(kLinearizeText) + '\n' + kStatusText);
  command.callback([&] { arguments.command = Arguments::Command::linearize; });
}

void add_study(CLI::App& program, Arguments& arguments) {
  CLI::App& command =
      *program.add_subcommand("study", "Run a scenario many times, with other values");
  command.add_option("STUDY", arguments.study, "Study file (TOML; see docs/studies.md)")
      ->required()
      ->type_name("FILE");
  add_out(command, arguments, "results/<name of the study>");
  command
      .add_option("--threads", arguments.options.threads.outer,
                  "Runs at once, each on a thread [the cores available]")
      ->check(CLI::Range(1, graph::kMostThreads))
      ->type_name("N");
  command.add_flag("--resume", arguments.resumes,
                   "Go on with the study that was begun in the folder, if one was");
  add_instructions(command, arguments);
  command.add_flag("--quiet", arguments.quiet, "Print nothing but warnings and errors");
  command.add_flag("-v,--verbose", arguments.verbosity, "Log to stderr; -vv logs more");
  command.footer(std::string(kStudyText) + '\n' + kStudyStatusText);
  command.callback([&] { arguments.command = Arguments::Command::study; });
}

void add_compare(CLI::App& program, Arguments& arguments) {
  CLI::App& compare = *program.add_subcommand(
      "compare", "Measure which executor and number of threads is fastest here");
  add_common(compare, arguments);
  add_out(compare, arguments, "results/<name of the scenario>/compare");
  add_compare_options(compare, arguments.compare);
  add_integrator(compare, arguments);
  compare.footer(std::string(kCompareText) + '\n' + kMeasuringStatusText);
  compare.callback([&] { arguments.command = Arguments::Command::compare; });
}

void add_predict(CLI::App& program, Arguments& arguments) {
  CLI::App& predict = *program.add_subcommand(
      "predict", "Predict how fast a step is on more threads than there are");
  add_common(predict, arguments);
  add_out(predict, arguments, "results/<name of the scenario>/predict");
  add_predict_options(predict, arguments.predict);
  add_formulation(predict, arguments);
  add_integrator(predict, arguments);
  predict.footer(std::string(kPredictText) + '\n' + kMeasuringStatusText);
  predict.callback([&] {
    arguments.command = Arguments::Command::predict;
    std::sort(arguments.predict.ranks.begin(), arguments.predict.ranks.end());
  });
}

void add_trace(CLI::App& program, Arguments& arguments) {
  CLI::App& trace = *program.add_subcommand("trace", "Record steps, node by node, to look at");
  add_common(trace, arguments);
  add_out(trace, arguments, "results/<name of the scenario>/trace");
  add_trace_options(trace, arguments.trace);
  add_running(trace, arguments);
  trace.footer(std::string(kTraceText) + '\n' + kStatusText);
  trace.callback([&] {
    arguments.command = Arguments::Command::trace;
    check_threads(arguments.options);
  });
}

void add_reproduce(CLI::App& program, Arguments& arguments) {
  CLI::App& reproduce =
      *program.add_subcommand("reproduce", "Repeat the paper's evaluation on this machine");
  add_out(reproduce, arguments, "results/reproduce");
  reproduce.add_flag("--quick", arguments.quick, "Few rounds, of rough times");
  reproduce.footer(std::string(kReproduceText) + '\n' + kMeasuringStatusText);
  reproduce.callback([&] { arguments.command = Arguments::Command::reproduce; });
}

/// Whether an argument is another KEY=VALUE behind --set, rather than an option or a file.
bool is_assignment(const std::string& argument) {
  const auto equals = argument.find('=');
  if (equals == std::string::npos || equals == 0 || argument[0] == '-') return false;
  return std::all_of(argument.begin(), argument.begin() + static_cast<std::ptrdiff_t>(equals),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; });
}

/// "--set a=1 b=2" as "--set a=1 --set b=2": a list that ends by itself before SCENARIO.
std::vector<std::string> repeat_set(const std::vector<std::string>& arguments) {
  std::vector<std::string> repeated;
  bool in_list = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool first = i > 0 && arguments[i - 1] == "--set";
    in_list = first || (in_list && is_assignment(arguments[i]));
    if (in_list && !first) repeated.emplace_back("--set");
    repeated.push_back(arguments[i]);
  }
  return repeated;
}

/// A scenario whose name begins as an option does, as a path that does not.
std::string as_path(const std::string& argument) {
  const bool is_file = argument.starts_with('-') && argument.ends_with(".toml") &&
                       argument.find('=') == std::string::npos;
  return is_file ? "./" + argument : argument;
}

/// Refuses what is neither a command nor an option of the program. The name for messages.
std::string check_first(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    throw InputError("spoke: no command, expected " + std::string(kCommands) +
                     " (see spoke --help)");
  }
  const std::string& first = arguments[0];
  if (first == "run" || first == "check" || first == "static" || first == "modes" ||
      first == "campbell" || first == "linearize" || first == "study" || first == "compare" ||
      first == "predict" || first == "trace" || first == "reproduce")
    return "spoke " + first;
  if (first == "-h" || first == "--help" || first == "--version") return "spoke";
  throw InputError("spoke: unknown command \"" + first + "\", expected " + std::string(kCommands) +
                   " (see spoke --help)");
}

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& arguments) {
  Arguments result;
  CLI::App program("Spoke simulates flexible multibody systems; every step is a task graph.",
                   "spoke");
  program.set_version_flag("--version", "spoke " SPOKE_VERSION, "Print the version");
  program.footer(std::string(kProgramText) + '\n' + kStatusText);
  program.require_subcommand(1);
  add_run(program, result);
  add_check(program, result);
  add_static(program, result);
  add_modes(program, result);
  add_campbell(program, result);
  add_linearize(program, result);
  add_study(program, result);
  add_compare(program, result);
  add_predict(program, result);
  add_trace(program, result);
  add_reproduce(program, result);

  const std::string name = check_first(arguments);
  std::vector<std::string> reversed = repeat_set(arguments);
  std::transform(reversed.begin(), reversed.end(), reversed.begin(), as_path);
  std::reverse(reversed.begin(), reversed.end());
  try {
    program.parse(reversed);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    program.exit(help, text, text);
    print(text.str());
    result.command = Arguments::Command::none;
  } catch (const CLI::ExtrasError&) {
    std::vector<std::string> extras = program.remaining(true);
    std::erase(extras, "--");
    throw InputError(name + ": unexpected argument " + extras.front() + " (see " + name +
                     " --help)");
  } catch (const CLI::ParseError& error) {
    throw InputError(name + ": " + error.what() + " (see " + name + " --help)");
  }
  return result;
}

}  // namespace spoke::cli
