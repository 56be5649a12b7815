// Times nodes and measured processes in the same rounds, predicts, and writes table and files.

#include "bench/programs/predict_command.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "bench/compare/probe.h"
#include "bench/predict/conclusion.h"
#include "bench/predict/files.h"
#include "bench/predict/table.h"
#include "bench/programs/measure_child.h"
#include "engine/results.h"
#include "engine/simulation/node_measurement.h"
#include "engine/step/sharing.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/text_file.h"
#include "program/cli/build_simulation.h"
#include "program/cli/interruption.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/standard_streams.h"
#include "program/ranks/launch.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kBatchSeconds = 0.05;
constexpr int kRounds = 15;

/// The subject of a prediction: options and scenario.
struct Task {
  const Arguments& arguments;
  const PredictArguments& own;
  std::string text;   ///< text of the scenario file
  Scenario scenario;  ///< with the values in force
};

Task read_task(const Arguments& arguments, const PredictArguments& own) {
  Task task{arguments, own, read_text(arguments.scenario), {}};
  task.scenario = parse_scenario(task.text, arguments.scenario, arguments.overrides);
  if (arguments.integrator) task.scenario.integration.method = *arguments.integrator;
  return task;
}

/// A simulation whose nodes are timed while it makes the steps of a measured process.
struct Subject {
  Simulation simulation;
  int window = 1;  ///< approximate number of steps that a run of its graph makes
};

/// The graphs whose nodes are timed: the one that all executors but auto run, and that of the
/// window which auto chooses, if it is another.
struct Subjects {
  std::int64_t batch = 2;  ///< number of steps in a round
  Subject all;
  std::optional<Subject> of_auto = {};
};

SimulationOptions options_for_all(const Task& task) {
  return {.formulation = task.arguments.options.formulation,
          .executor = ExecutorKind::serial,
          .threads = 1,
          .window = task.own.window};
}

bool runs_single_passes(const Simulation& simulation) {
  return simulation.run_graph().node_count() == simulation.step_graph().node_count();
}

/// Returns the simulation in auto's window. None if auto runs the same graph as the others: on one
/// thread, or in a window that was asked for.
std::optional<Subject> open_window(const Task& task, const Scenario& scenario) {
  const PredictArguments& asked = task.own;
  if (asked.window > 0 || asked.threads.back() == 1) return {};
  Subject subject{Simulation(scenario, {.formulation = task.arguments.options.formulation,
                                        .executor = ExecutorKind::automatic,
                                        .threads = 2})};  // any number gives this window
  subject.window = open_window(subject.simulation);
  if (runs_single_passes(subject.simulation)) return {};
  return subject;
}

Subjects make_subjects(const Task& task) {
  constexpr std::int64_t kEnoughToProbe = 8192;
  const SimulationOptions options = options_for_all(task);
  const Simulation given = build_simulation(task.arguments.scenario, task.scenario, options);
  Simulation probe(compare::with_steps(given, kEnoughToProbe), options);
  const std::int64_t batch = predict::choose_steps(probe, kBatchSeconds);
  // The length must also suffice for the steps by which auto chooses its window.
  const Scenario longer =
      compare::with_steps(given, compare::steps_of(batch, kRounds) + kEnoughToProbe);
  return {
      batch, {Simulation(longer, options), std::max(options.window, 1)}, open_window(task, longer)};
}

predict::RunGraph describe(const Subject& subject) {
  const graph::StepGraph& graph = subject.simulation.run_graph();
  return {.window = subject.window,
          .is_one_pass = runs_single_passes(subject.simulation),
          .node_count = graph.node_count(),
          .edge_count = graph.edge_count()};
}

predict::Prediction describe(const Arguments& arguments, const Subjects& subjects) {
  const Simulation& simulation = subjects.all.simulation;
  predict::Prediction prediction{.scenario = simulation.scenario(),
                                 .formulation = arguments.options.formulation};
  prediction.step_size = simulation.step_size();
  prediction.size = simulation.size();
  prediction.run = describe(subjects.all);
  if (subjects.of_auto) prediction.auto_run = describe(*subjects.of_auto);
  prediction.rounds = kRounds;
  return prediction;
}

/// Makes the steps that a measured process makes before its first round; on one thread, and by the
/// graph that is timed.
void warm_up(Subject& subject, std::int64_t batch) {
  const std::int64_t steps = compare::steps_of(batch, 0);
  Simulation& simulation = subject.simulation;
  while (simulation.steps() < steps)
    measure_nodes(simulation, std::min(batch, steps - simulation.steps()));
}

/// Times the nodes of all subjects, over the same steps.
class SubjectTimer {
 public:
  explicit SubjectTimer(Subjects& subjects)
      : batch_(subjects.batch), all_(subjects.all.simulation) {
    warm_up(subjects.all, batch_);
    if (!subjects.of_auto) return;
    warm_up(*subjects.of_auto, batch_);
    of_auto_.emplace(subjects.of_auto->simulation);
  }

  void measure() {
    all_.measure(batch_);
    if (of_auto_) of_auto_->measure(batch_);
  }
  void summarise(predict::Prediction& prediction) const {
    prediction.run.nodes = all_.summarise();
    if (of_auto_) prediction.auto_run->nodes = of_auto_->summarise();
  }

 private:
  std::int64_t batch_;
  predict::NodeTimer all_;
  std::optional<predict::NodeTimer> of_auto_;
};

/// Measures executors on the numbers of threads that this machine has, in child processes, and
/// times the nodes in the same rounds over the same steps.
std::vector<compare::Measurement> measure(const Task& task, const Subjects& subjects,
                                          SubjectTimer& timer, int cores) {
  const Arguments& arguments = task.arguments;
  compare::Axes axes{.formulations = {arguments.options.formulation},
                     .executors = predict::predictable_executors(),
                     .threads = {},
                     .waits = {compare::Wait::runtime_default},
                     .binds = {false}};
  for (const int threads : task.own.threads)
    if (threads <= cores) axes.threads.emplace_back(threads);
  if (axes.threads.empty()) axes.executors.clear();  // serial remains
  const Scenario& scenario = subjects.all.simulation.scenario();
  const auto configurations =
      compare::make_configurations(axes, static_cast<int>(scenario.rotor.blades.size()), cores);
  const ChildTask child{.scenario = arguments.scenario,
                        .text = task.text,
                        .overrides = arguments.overrides,
                        .integration = scenario.integration,
                        .window = task.own.window};
  return compare::measure(
      configurations,
      [&](const compare::Configuration& configuration) {
        return make_child_command(child, configuration);
      },
      [&](Formulation) { return subjects.batch; },
      {.rounds = kRounds,
       .most_seconds = std::max(1.5, 4.0 * kBatchSeconds * kRounds),
       .shrinks_batches = true},
      show_progress,
      [&] {
        show_progress("timing nodes");
        timer.measure();
      });
}

/// Returns the network between the processes that mpirun has started, unless its latency was given.
/// Only the first process goes on, and MPI ends with the others, so that nothing disturbs the
/// measurement.
std::optional<predict::Network> find_network(const PredictArguments& asked) {
  const ranks::Launch launch;
  const double measured = launch.measure_latency();
  if (!launch.is_first()) return {};
  if (asked.latency) return predict::Network{*asked.latency, false};
  return launch.count() > 1 ? predict::Network{measured, true} : predict::Network{};
}

void predict_ranks(const PredictArguments& asked, Simulation& simulation,
                   predict::Prediction& prediction) {
  const int window = asked.window > 1 ? 2 * asked.window : kMostSharedSteps;
  prediction.ranks = predict::predict_ranks(
      predict::find_shares(simulation.run_graph(), prediction.run.nodes.serial, window),
      prediction.network, asked.ranks,
      [&simulation](int count) { return share_subsystems(simulation, count); });
}

/// Throws InputError, before anything is measured, unless there are as many subsystems as
/// processes.
void require_ranks(const PredictArguments& asked, Simulation& simulation) {
  const int subsystems = simulation.size().subsystems;
  if (!asked.ranks.empty() && asked.ranks.back() > subsystems)
    throw InputError(fmt::format("--ranks {}: the model has {}, expected at most so many processes",
                                 asked.ranks.back(), counted(subsystems, "subsystem")));
}

void write(const predict::Prediction& prediction, const fs::path& folder) {
  write_together([&] {
    write_file(folder / "predict.json", predict::make_json(prediction));
    write_file(folder / "predict.csv", predict::make_csv(prediction));
    write_file(folder / "predict.html", predict::make_html(prediction));
  });
}

void print(const predict::Prediction& prediction, const fs::path& folder) {
  print_title(prediction.scenario.title);
  for (const auto& [label, text] : predict::make_facts(prediction)) print_line(label, text);
  print_table(predict::make_table(prediction));
  if (!prediction.ranks.empty()) print_table(predict::make_rank_table(prediction));
  cli::print('\n' + predict::make_conclusion(prediction) + '\n');
  print_line("written", (folder / "predict.html").string() + ", predict.json, predict.csv");
}

}  // namespace

int predict(const Arguments& arguments, const PredictArguments& own) {
  const std::optional<predict::Network> network = find_network(own);
  if (!network) return 0;
  const Task task = read_task(arguments, own);
  const fs::path folder = arguments.out.empty()
                              ? fs::path("results") / task.scenario.name / "predict"
                              : fs::path(arguments.out);
  require_folder(folder, {"predict.json", "predict.csv", "predict.html"});
  const ResultsFolder taken(folder);
  const Machine machine = this_machine();
  const double load_before = load_average();
  show_progress("warming up: nodes");
  Subjects subjects = make_subjects(task);
  require_ranks(own, subjects.all.simulation);
  predict::Prediction prediction = describe(arguments, subjects);
  prediction.network = *network;
  prediction.machine = machine;
  prediction.capacity = measure_capacity();
  prediction.load_before = load_before;
  SubjectTimer timer(subjects);
  const auto measurements = measure(task, subjects, timer, machine.cores);
  timer.summarise(prediction);
  prediction.runtime = graph::measure_runtime_costs();
  prediction.load_after = load_average();
  prediction.capacity.after = measure_capacity().after;
  show_progress("predicting");
  const auto& of_auto = subjects.of_auto;
  predict::predict(prediction, subjects.all.simulation.run_graph(),
                   of_auto ? &of_auto->simulation.run_graph() : nullptr, own.threads);
  predict::add_measured(prediction, measurements);
  predict_ranks(own, subjects.all.simulation, prediction);
  show_progress("");
  write(prediction, folder);
  print(prediction, folder);
  return 0;
}

}  // namespace spoke::cli
