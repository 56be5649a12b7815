#include "engine/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <iostream>
#include <utility>

#include "engine/cli/compare_arguments.h"
#include "engine/cli/threads_option.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

constexpr const char* kCommands = "run, check, compare, predict, trace or reproduce";

constexpr const char* kStatusText = R"(Exit status:
  0  done
  1  a fault in spoke itself
  2  bad command line or scenario, or output that cannot be written;
     the message on stderr says file:line:column, key, what is wrong and what is expected
  3  the simulation diverged; results so far are kept
  130, 143  SIGINT or SIGTERM ended a run; results so far are kept
)";

constexpr const char* kRunText = R"(Output files, in the folder of --out:
  sensors.csv   a row per output time: t, tip displacements, hub motion and torque, energies
  summary.json  all values in force, machine, steps, wall time, hash of the final state, and
                the extremes of every sensor over all steps
  report.html   a page to look at: plots over time, the rotor moving, all numbers; needs no network
  vtk/          with --vtk: blades.pvd for ParaView and a file for each output time
  checkpoint.spoke  with --checkpoint-every: what --resume goes on from, see docs/checkpoint.md

The first Ctrl-C (SIGINT) or SIGTERM completes the step, writes rows, summary and checkpoint, and
ends; the second SIGINT ends at once.

Examples:
  spoke run models/wu_haug_rotor.toml --set blade.bodies=8 --set integration.step=0.01
  spoke run long.toml --checkpoint-every 60
  spoke run long.toml --checkpoint-every 60 --resume results/long/checkpoint.spoke
)";

constexpr const char* kCheckText =
    R"(Prints subsystems, bodies, coordinates and joints, nodes and edges of the step graph, lowest and
highest natural frequency at rest, the largest step that rk4 is stable at, and the step in force.
Writes no files. Warns on stderr if the scenario's method is rk4 and its step is not stable.

Example:
  spoke check models/wu_haug_rotor.toml --set blade.elements=8
)";

constexpr const char* kCompareText =
    R"(Measures all combinations in interleaved rounds, each in a process of its own, and compares times
per step and bits with those of the executor serial. Takes a minute or so.

Output files, in the folder of --out:
  compare.html  conclusion, charts and tables
  compare.csv   a row of figures per combination
  compare.json  everything, all samples included

Example:
  spoke compare models/wu_haug_rotor.toml --threads 1,2 --formulations subsystem
)";

constexpr const char* kPredictText =
    R"(Times the nodes of a step one by one on one thread and simulates what executors make of them on
other numbers of threads; measures those that this machine has processors for beside it.

Output files, in the folder of --out:
  predict.html  conclusion, charts and table
  predict.csv   a row per executor and number of threads
  predict.json  everything, the costs of all nodes included

Example:
  spoke predict models/wu_haug_rotor.toml --formulation subsystem --window 8
)";

constexpr const char* kTraceText =
    R"(Records which thread runs which node of the step graph when, in the steps that follow --from. The
steps are those of spoke run: same graph, same executor, same bits.

Output files, in the folder of --out:
  trace.json  Chrome trace events, for https://ui.perfetto.dev and chrome://tracing
  graph.dot   the step graph, coloured by share of the time, with its longest path
  graph.svg   the same as a picture, if Graphviz is installed
  trace.html  graph and threads side by side, in one page, if the program was built with it

Example:
  spoke trace models/wu_haug_rotor.toml --formulation subsystem --executor flow_graph
)";

constexpr const char* kReproduceText =
    R"(Tables and figures of Han, Song and Kim (2017), computed and measured on this machine, beside the
paper's own numbers: operation counts, drive, deflection, two schemes of nested threads, methods.
The model is built in. Takes one to three minutes; --quick less than 20 s, with rough times.

Output files, in the folder of --out:
  reproduce.html  tables, charts, and for each what agrees and what differs
  reproduce.json  all of it, samples included

Example:
  spoke reproduce --out results/paper
)";

constexpr const char* kProgramText = R"(Examples:
  spoke run models/wu_haug_rotor.toml
  spoke check models/wu_haug_rotor.toml
  spoke compare models/wu_haug_rotor.toml
  spoke predict models/wu_haug_rotor.toml
  spoke trace models/wu_haug_rotor.toml
  spoke reproduce

"spoke run --help" and so on explain options and output of the commands.
)";

/// The names of all values of an enumeration and back.
template <class Enum>
class Names {
 public:
  Names(std::initializer_list<Enum> values) : values_(values) {}

  std::vector<std::string> all() const {
    std::vector<std::string> names;
    for (const Enum value : values_) names.emplace_back(name_of(value));
    return names;
  }
  Enum value(const std::string& name) const {
    return *std::find_if(values_.begin(), values_.end(),
                         [&](Enum v) { return name_of(v) == name; });
  }

 private:
  std::vector<Enum> values_;
};

template <class Enum, class Assign>
void add_choice(CLI::App& command, const std::string& option, const std::string& text,
                const Names<Enum>& names, Assign assign) {
  command
      .add_option_function<std::string>(
          option, [names, assign](const std::string& name) { assign(names.value(name)); }, text)
      ->check(CLI::IsMember(names.all()))
      ->type_name("NAME");
}

void add_common(CLI::App& command, Arguments& arguments) {
  command.add_option("SCENARIO", arguments.scenario, "Scenario file (TOML; see docs/scenario.md)")
      ->required()
      ->type_name("FILE");
  command
      .add_option(
          "--set",
          [&arguments](const CLI::results_t& assignments) {
            arguments.overrides = assignments;
            return true;
          },
          "Override a key of the scenario; may be repeated.\n"
          "The value is TOML, a bare word is text:\n"
          "  --set blade.bodies=8 --set blades.2.length=7.5\n"
          "  --set load.1.force=[0,1] --set blade.reference_frame=chord")
      ->type_name("KEY=VALUE")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  command.add_flag("-v,--verbose", arguments.verbosity, "Log to stderr; -vv logs more");
}

void add_formulation(CLI::App& command, Arguments& arguments) {
  add_choice<Formulation>(
      command, "--formulation", "How accelerations are computed [structured]",
      {Formulation::structured, Formulation::subsystem, Formulation::augmented},
      [&](Formulation formulation) { arguments.options.formulation = formulation; });
}

void add_integrator(CLI::App& command, Arguments& arguments) {
  add_choice<IntegrationMethod>(command, "--integrator",
                                "Integration method\n[what the scenario says; generalized_alpha]",
                                {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4},
                                [&](IntegrationMethod method) { arguments.integrator = method; });
}

/// Like a choice, but a name may be one that this build is without, and the message then says so.
void add_executor(CLI::App& run, Arguments& arguments) {
  std::string names;
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (!names.empty()) names += ',';
    names += name_of(kind);
  }
  const auto find_fault = [](const std::string& name) -> std::string {
    try {
      graph::executor_kind(name);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  };
  run.add_option_function<std::string>(
         "--executor",
         [&](const std::string& name) { arguments.options.executor = graph::executor_kind(name); },
         "What runs the task graph of a step [auto]")
      ->check(CLI::Validator(find_fault, '{' + names + '}'))
      ->type_name("NAME");
}

/// Whether the executor runs on such threads, of which one option says nothing of the other.
void check_threads(const SimulationOptions& options) {
  try {
    graph::check_threads(options.executor, options.threads);
  } catch (const InputError& error) {
    throw CLI::ValidationError("--threads", error.what());
  }
}

void add_checkpoints(CLI::App& run, Arguments& arguments) {
  run.add_option_function<double>(
         "--checkpoint-every",
         [&](double seconds) {
           if (!(seconds > 0.0))
             throw CLI::ValidationError("--checkpoint-every", "expected a number above 0");
           arguments.checkpoint_every = seconds;
         },
         "Write checkpoint.spoke each time so many seconds\nof wall time have passed, and at the "
         "end")
      ->type_name("SECONDS");
  run.add_option("--resume", arguments.resume,
                 "Go on from a checkpoint, with the rows beside it\n"
                 "(the same SCENARIO and --set; --out unless given: its folder)")
      ->type_name("FILE");
}

/// What runs the steps, of commands that simulate.
void add_running(CLI::App& command, Arguments& arguments) {
  add_formulation(command, arguments);
  add_integrator(command, arguments);
  add_executor(command, arguments);
  command
      .add_option_function<std::string>(
          "--threads",
          [&](const std::string& text) { arguments.options.threads = parse_threads_option(text); },
          "Threads of the executor, or OUTERxINNER of nested teams\n[the cores available]")
      ->type_name("N|OxI");
  command
      .add_option("--window", arguments.options.window,
                  "Steps of one run of the executor, where the hub is prescribed\n"
                  "[auto chooses; the others take 1]")
      ->check(CLI::Range(1, kMostWindow))
      ->type_name("STEPS");
}

void add_run(CLI::App& program, Arguments& arguments) {
  CLI::App& run = *program.add_subcommand("run", "Simulate a scenario and write its results");
  add_common(run, arguments);
  run.add_option("--out", arguments.out, "Folder of the results [results/<name of the scenario>]")
      ->type_name("DIR");
  add_running(run, arguments);
  add_checkpoints(run, arguments);
  run.add_flag_callback(
      "--no-report", [&] { arguments.writes_report = false; }, "Do not write report.html");
  run.add_flag("--vtk", arguments.writes_vtk,
               "Write the deformed blades at all output times for ParaView");
  run.add_option("--trace", arguments.trace_out,
                 "Record the first 20 steps, node by node, and write the files of\n"
                 "spoke trace to this folder, too\n(with --vtk only up to the first output time)")
      ->type_name("DIR");
  run.add_flag("--quiet", arguments.quiet, "Print nothing but errors");
  run.footer(std::string(kRunText) + '\n' + kStatusText);
  run.callback([&] {
    arguments.command = Arguments::Command::run;
    check_threads(arguments.options);
  });
}

void add_check(CLI::App& program, Arguments& arguments) {
  CLI::App& check = *program.add_subcommand("check", "Validate a scenario and print its model");
  add_common(check, arguments);
  check.footer(std::string(kCheckText) + '\n' + kStatusText);
  check.callback([&] { arguments.command = Arguments::Command::check; });
}

void add_compare(CLI::App& program, Arguments& arguments) {
  CLI::App& compare = *program.add_subcommand(
      "compare", "Measure which executor and number of threads is fastest here");
  add_common(compare, arguments);
  compare
      .add_option("--out", arguments.out,
                  "Folder of the results [results/<name of the scenario>/compare]")
      ->type_name("DIR");
  add_compare_options(compare, arguments.compare);
  add_integrator(compare, arguments);
  compare.footer(std::string(kCompareText) + '\n' + kStatusText);
  compare.callback([&] { arguments.command = Arguments::Command::compare; });
}

void add_predict(CLI::App& program, Arguments& arguments) {
  CLI::App& predict = *program.add_subcommand(
      "predict", "Predict how fast a step is on more threads than there are");
  add_common(predict, arguments);
  predict
      .add_option("--out", arguments.out,
                  "Folder of the results [results/<name of the scenario>/predict]")
      ->type_name("DIR");
  add_predict_options(predict, arguments.predict);
  add_formulation(predict, arguments);
  add_integrator(predict, arguments);
  predict.footer(std::string(kPredictText) + '\n' + kStatusText);
  predict.callback([&] { arguments.command = Arguments::Command::predict; });
}

void add_trace(CLI::App& program, Arguments& arguments) {
  CLI::App& trace = *program.add_subcommand("trace", "Record steps, node by node, to look at");
  add_common(trace, arguments);
  trace
      .add_option("--out", arguments.out,
                  "Folder of the results [results/<name of the scenario>/trace]")
      ->type_name("DIR");
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
  reproduce.add_option("--out", arguments.out, "Folder of the results [results/reproduce]")
      ->type_name("DIR");
  reproduce.add_flag("--quick", arguments.quick, "Few rounds, of rough times");
  reproduce.footer(std::string(kReproduceText) + '\n' + kStatusText);
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

/// Refuses what is neither a command nor an option of the program. The name for messages.
std::string check_first(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    throw InputError("spoke: no command, expected " + std::string(kCommands) +
                     " (see spoke --help)");
  }
  const std::string& first = arguments[0];
  if (first == "run" || first == "check" || first == "compare" || first == "predict" ||
      first == "trace" || first == "reproduce")
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
  add_compare(program, result);
  add_predict(program, result);
  add_trace(program, result);
  add_reproduce(program, result);

  const std::string name = check_first(arguments);
  std::vector<std::string> reversed = repeat_set(arguments);
  std::reverse(reversed.begin(), reversed.end());
  try {
    program.parse(reversed);
  } catch (const CLI::Success& help) {
    program.exit(help, std::cout, std::cerr);
    result.command = Arguments::Command::none;
  } catch (const CLI::ExtrasError&) {
    throw InputError(name + ": unexpected argument " + program.remaining(true).front() + " (see " +
                     name + " --help)");
  } catch (const CLI::ParseError& error) {
    throw InputError(name + ": " + error.what() + " (see " + name + " --help)");
  }
  return result;
}

}  // namespace spoke::cli
