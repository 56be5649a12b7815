// Makes configurations from the options, measures them in rounds, prints a table and writes the
// files.

#include "bench/programs/compare_command.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>

#include "bench/compare/conclusion.h"
#include "bench/compare/files.h"
#include "bench/compare/probe.h"
#include "bench/compare/table.h"
#include "bench/programs/measure_child.h"
#include "engine/results.h"
#include "engine/support/machine.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/text_file.h"
#include "program/cli/interruption.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/standard_streams.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kSampleSeconds = 0.03;
// Planned steps for each step that is made: auto plans only for a simulation of some length.
constexpr std::int64_t kPlanned = 4;
constexpr std::size_t kMostConfigurations = 400;  // a process, a socket and some threads each

int count_subsystems(const Scenario& scenario) {
  if (!scenario.space) return static_cast<int>(scenario.rotor.blades.size());
  return static_cast<int>(scenario.space->blades.size() + scenario.space->subsystems.size());
}

std::vector<compare::Configuration> choose_configurations(const compare::Axes& axes,
                                                          const Scenario& scenario, int cores) {
  auto list = compare::make_configurations(axes, count_subsystems(scenario), cores);
  if (list.size() > kMostConfigurations)
    throw InputError(
        fmt::format("{} configurations, expected at most {}: choose fewer executors, "
                    "numbers of threads or formulations",
                    list.size(), kMostConfigurations));
  return list;
}

/// Throws InputError if memory is short for all processes, which live at once, each with the whole
/// model.
void require_memory(const compare::Comparison& comparison,
                    const std::vector<compare::Configuration>& configurations) {
  constexpr double kProcess = 2e7;  // memory of a process besides its model [bytes]
  double needed = 0.0;
  for (const auto& configuration : configurations)
    needed += kProcess + static_cast<double>(
                             model_of(comparison, configuration.formulation).size.memory_bytes);
  const auto available = static_cast<double>(comparison.machine.memory);
  if (available > 0.0 && needed > 0.8 * available)
    throw InputError(
        fmt::format("{} at once {} {:.1f} GB of memory, this machine has "
                    "{:.1f} GB: compare fewer configurations",
                    counted(std::ssize(configurations), "process"),
                    configurations.size() == 1 ? "needs" : "need", needed / 1e9, available / 1e9));
}

void probe_models(compare::Comparison& comparison, const compare::Axes& axes) {
  for (const Formulation formulation : axes.formulations) {
    show_progress("probing: " + std::string(name_of(formulation)));
    comparison.models.push_back(compare::probe(comparison.scenario, formulation, kSampleSeconds));
  }
  const Simulation simulation(
      comparison.scenario,
      {.formulation = axes.formulations.front(), .executor = ExecutorKind::serial, .threads = 1});
  comparison.step_size = simulation.step_size();
  std::int64_t longest = 0;
  for (const compare::Model& model : comparison.models) longest = std::max(longest, model.batch);
  comparison.scenario =
      compare::with_steps(simulation, kPlanned * compare::steps_of(longest, comparison.rounds));
}

void print(const compare::Comparison& comparison, const fs::path& folder) {
  print_title(comparison.scenario.title);
  for (const compare::Model& model : comparison.models)
    print_table(compare::make_table(comparison, model));
  cli::print('\n' + compare::make_conclusion(comparison) + '\n');
  print_line("written", (folder / "compare.html").string() + ", compare.json, compare.csv");
}

void write(const compare::Comparison& comparison, const fs::path& folder) {
  write_together([&] {
    write_file(folder / "compare.json", compare::make_json(comparison));
    write_file(folder / "compare.csv", compare::make_csv(comparison));
    write_file(folder / "compare.html", compare::make_html(comparison));
  });
}

}  // namespace

int compare(const Arguments& arguments, const CompareArguments& own) {
  const std::string text = read_text(arguments.scenario);
  Scenario scenario = parse_scenario(text, arguments.scenario, arguments.overrides);
  if (arguments.integrator) scenario.integration.method = *arguments.integrator;
  const fs::path folder = arguments.out.empty() ? fs::path("results") / scenario.name / "compare"
                                                : fs::path(arguments.out);
  compare::Comparison comparison{.scenario = scenario, .rounds = own.rounds};
  comparison.machine = this_machine();
  const compare::Axes& axes = own.axes;
  const auto configurations = choose_configurations(axes, scenario, comparison.machine.cores);
  require_folder(folder, {"compare.json", "compare.csv", "compare.html"});
  const ResultsFolder taken(folder);
  comparison.loads.before = load_average();
  comparison.capacity = measure_capacity();
  probe_models(comparison, axes);
  require_memory(comparison, configurations);
  const ChildTask task{.scenario = arguments.scenario,
                       .text = text,
                       .overrides = arguments.overrides,
                       .integration = comparison.scenario.integration};
  const compare::Effort effort{
      .rounds = comparison.rounds,
      .most_seconds = std::max(1.5, 4.0 * kSampleSeconds * comparison.rounds)};
  auto measurements = compare::measure(
      configurations,
      [&](const compare::Configuration& configuration) {
        return make_child_command(task, configuration);
      },
      [&](Formulation formulation) { return model_of(comparison, formulation).batch; }, effort,
      show_progress);
  comparison.loads.after = load_average();
  comparison.capacity.after = measure_capacity().after;
  compare::evaluate(comparison, std::move(measurements));
  write(comparison, folder);
  print(comparison, folder);
  return 0;
}

}  // namespace spoke::cli
