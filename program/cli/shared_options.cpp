// Adds the shared options to a command, with their choices and help.

#include "program/cli/shared_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <initializer_list>
#include <span>
#include <vector>

#include "models/error.h"
#include "program/cli/threads_option.h"

namespace spoke::cli {
namespace {

/// Maps values of an enumeration to their names and back.
template <class Enum>
class Names {
 public:
  Names(std::span<const Enum> values) : values_(values.begin(), values.end()) {}
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

/// Adds --executor. A name may be that of an executor that this build lacks; the message then says
/// so.
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

/// Throws CLI::ValidationError unless the executor runs on such threads; neither option alone shows
/// that.
void check_threads(const SimulationOptions& options) {
  try {
    graph::check_threads(options.executor, options.threads);
  } catch (const InputError& error) {
    throw CLI::ValidationError("--threads", error.what());
  }
}

}  // namespace

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

void add_integrator(CLI::App& command, Arguments& arguments) {
  add_choice<IntegrationMethod>(command, "--integrator",
                                "Integration method\n[what the scenario says; generalized_alpha]",
                                {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4},
                                [&](IntegrationMethod method) { arguments.integrator = method; });
}

void add_path(CLI::App& command, const std::string& option, std::string& path,
              const std::string& text, const std::string& kind) {
  const std::string expected = kind == "DIR" ? "a folder" : "a file";
  command.add_option(option, path, text)
      ->check(CLI::Validator(
          [expected](const std::string& name) {
            return name.empty() ? "expected the name of " + expected + ", got an empty one" : "";
          },
          ""))
      ->type_name(kind);
}

void add_out(CLI::App& command, Arguments& arguments, const std::string& unless_given) {
  add_path(command, "--out", arguments.out, "Folder of the results [" + unless_given + "]", "DIR");
  add_force(command, arguments);
}

void add_force(CLI::App& command, Arguments& arguments) {
  command.add_flag("--force", arguments.replaces_other_kinds,
                   "Replace files that are not of the kind that is written, too;\n"
                   "never those that the command reads");
}

void add_instructions(CLI::App& command, Arguments& arguments) {
  command
      .add_option("--instructions", arguments.instructions,
                  "baseline: the same bits on every machine;\navx2: on all that have AVX2, and "
                  "faster; auto: AVX-512\nor AVX2 where this one has them [auto]")
      ->check(CLI::IsMember({"auto", "avx2", "baseline"}))
      ->type_name("NAME");
}

void add_running(CLI::App& command, Arguments& arguments) {
  add_choice<Formulation>(
      command, "--formulation", "How accelerations are computed [structured]", formulations(),
      [&](Formulation formulation) { arguments.options.formulation = formulation; });
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
  add_instructions(command, arguments);
  command.callback([&] { check_threads(arguments.options); });
}

}  // namespace spoke::cli
