#include "engine/cli/predict_command.h"

#include <spdlog/fmt/fmt.h>

#include "engine/cli/build_simulation.h"
#include "engine/cli/measure_child_command.h"
#include "engine/cli/progress_line.h"
#include "engine/cli/report.h"
#include "engine/cli/results_folder.h"
#include "engine/compare/probe.h"
#include "engine/predict/conclusion.h"
#include "engine/predict/files.h"
#include "engine/predict/table.h"
#include "engine/results.h"
#include "models/text_file.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kBatchSeconds = 0.05;
constexpr int kRounds = 15;

/// The simulation whose nodes are timed, which makes the steps of a measured process.
struct Subject {
  Simulation simulation;
  std::int64_t batch = 2;  ///< steps of a round
};

Subject make_subject(const Arguments& arguments, const Scenario& scenario) {
  constexpr std::int64_t kEnoughToProbe = 8192;
  const SimulationOptions options{.formulation = arguments.options.formulation,
                                  .executor = ExecutorKind::serial,
                                  .threads = 1,
                                  .window = arguments.predict.window};
  const Simulation given = build_simulation(arguments.scenario, scenario, options);
  Simulation probe(compare::with_steps(given, kEnoughToProbe), options);
  const std::int64_t batch = predict::choose_steps(probe, kBatchSeconds);
  const std::int64_t all = compare::steps_of(batch, kRounds) + arguments.predict.window;
  return {Simulation(compare::with_steps(given, all), options), batch};
}

predict::Prediction describe(const Arguments& arguments, const Simulation& simulation) {
  predict::Prediction prediction{.scenario = simulation.scenario(),
                                 .formulation = arguments.options.formulation};
  const graph::StepGraph& graph = simulation.run_graph();
  const bool has_window = &graph != &simulation.step_graph();
  prediction.window = has_window ? arguments.predict.window : 1;
  prediction.step_size = simulation.step_size();
  prediction.size = simulation.size();
  prediction.run_nodes = graph.node_count();
  prediction.run_edges = graph.edge_count();
  prediction.machine = this_machine();
  prediction.load_before = load_average();
  return prediction;
}

/// The steps that a measured process makes before its first round.
void warm_up(Subject& subject) {
  const std::int64_t steps = compare::steps_of(subject.batch, 0);
  subject.simulation.run_until(static_cast<double>(steps) * subject.simulation.step_size());
}

/// Executors on the numbers of threads that this machine has, in child processes; in the same
/// rounds the nodes, over the same steps.
std::vector<compare::Measurement> measure(const Arguments& arguments, const std::string& text,
                                          Subject& subject, predict::NodeTimer& timer, int cores) {
  compare::Axes axes{.formulations = {arguments.options.formulation},
                     .executors = predict::predictable_executors(),
                     .threads = {},
                     .waits = {compare::Wait::runtime_default},
                     .binds = {false}};
  for (const int threads : arguments.predict.threads)
    if (threads <= cores) axes.threads.emplace_back(threads);
  if (axes.threads.empty()) axes.executors.clear();  // leaves serial
  const Scenario& scenario = subject.simulation.scenario();
  const auto configurations =
      compare::make_configurations(axes, static_cast<int>(scenario.rotor.blades.size()), cores);
  const ChildTask task{arguments.scenario, text, arguments.overrides, scenario.integration,
                       arguments.predict.window};
  return compare::measure(
      configurations,
      [&](const compare::Configuration& configuration) {
        return make_child_command(task, configuration);
      },
      [&](Formulation) { return subject.batch; },
      {.rounds = kRounds, .most_seconds = std::max(1.5, 4.0 * kBatchSeconds * kRounds)},
      show_progress,
      [&] {
        show_progress("timing nodes");
        timer.measure(subject.batch);
      });
}

void write(const predict::Prediction& prediction, const fs::path& folder) {
  make_folder(folder);
  write_file(folder / "predict.json", predict::make_json(prediction));
  write_file(folder / "predict.csv", predict::make_csv(prediction));
  write_file(folder / "predict.html", predict::make_html(prediction));
}

void print(const predict::Prediction& prediction, const fs::path& folder) {
  fmt::print("{}\n", one_line(prediction.scenario.title));
  for (const auto& [label, text] : predict::make_facts(prediction)) print_line(label, text);
  print_table(predict::make_table(prediction));
  fmt::print("\n{}\n", predict::make_conclusion(prediction));
  print_line("written", (folder / "predict.html").string() + ", predict.json, predict.csv");
}

}  // namespace

int predict(const Arguments& arguments) {
  const std::string text = read_text(arguments.scenario);
  Scenario scenario = parse_scenario(text, arguments.scenario, arguments.overrides);
  if (arguments.integrator) scenario.integration.method = *arguments.integrator;
  const fs::path folder = arguments.out.empty() ? fs::path("results") / scenario.name / "predict"
                                                : fs::path(arguments.out);
  demand_folder(folder);
  show_progress("warming up: nodes");
  Subject subject = make_subject(arguments, scenario);
  predict::Prediction prediction = describe(arguments, subject.simulation);
  warm_up(subject);
  predict::NodeTimer timer(subject.simulation);
  const auto measurements = measure(arguments, text, subject, timer, prediction.machine.cores);
  prediction.rounds = kRounds;
  prediction.nodes = timer.summarise();
  prediction.runtime = graph::runtime_costs();
  prediction.load_after = load_average();
  show_progress("predicting");
  predict::predict(prediction, subject.simulation.run_graph(), arguments.predict.threads);
  predict::add_measured(prediction, measurements);
  show_progress("");
  write(prediction, folder);
  print(prediction, folder);
  return 0;
}

}  // namespace spoke::cli
