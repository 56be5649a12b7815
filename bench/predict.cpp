// The question "predict": how far predicted times are from measured ones, on graphs of known costs
// and on rotors.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench/busy_graph.h"
#include "bench/interleaved.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "graph/calibrate/measuring_executor.h"
#include "graph/calibrate/quantiles.h"
#include "graph/machine/duration_text.h"
#include "graph/tune/run_prediction.h"

namespace spoke::bench {
namespace {

using graph::Executor;
using graph::NodeOrder;
using graph::StepGraph;

// Long against the milliseconds that a sleeping thread takes to wake.
constexpr double kBatch = 20e-3;  // s

/// Something to run and to predict. A turn is a number of runs.
class Subject {
 public:
  virtual ~Subject() = default;
  virtual std::string name() const = 0;
  virtual const StepGraph& graph() const = 0;
  /// Whether the executor runs that graph. On one thread auto makes no windows.
  virtual bool is_run_by(ExecutorKind kind, int threads) const {
    return kind != ExecutorKind::automatic || threads > 1 || !has_window();
  }
  /// What makes a turn with an executor, settled.
  virtual std::function<void()> turn(ExecutorKind kind, int threads) = 0;
  /// Makes a turn on one thread, node by node.
  virtual NodeMeasurement measure_turn(NodeOrder order) = 0;
  virtual double runs_per_turn() const = 0;

 private:
  virtual bool has_window() const { return false; }
};

/// A graph of busy nodes.
class Synthetic final : public Subject {
 public:
  Synthetic(const StepShape& shape, double node_seconds)
      : name_(shape.name() + ", nodes of " + graph::duration_text(node_seconds)),
        graph_(make_busy_graph(shape, node_seconds)),
        runs_(static_cast<int>(std::max(1.0, kBatch / (node_seconds * graph_.node_count())))) {}

  std::string name() const override { return name_; }
  const StepGraph& graph() const override { return graph_; }
  std::function<void()> turn(ExecutorKind kind, int threads) override {
    const std::shared_ptr<Executor> executor = graph::make_executor(graph_, kind, threads);
    while (executor->tuning()) executor->run();
    return [executor, runs = runs_] { run_repeatedly(*executor, runs); };
  }
  NodeMeasurement measure_turn(NodeOrder order) override {
    graph::MeasuringExecutor executor(graph_, order);
    run_repeatedly(executor, runs_);
    return {executor.node_costs(), executor.run_times(), executor.between_runs(), 1.0};
  }
  double runs_per_turn() const override { return runs_; }

 private:
  static void run_repeatedly(Executor& executor, int runs) {
    int left = runs;
    executor.run_while([&left] { return --left > 0; });
  }

  std::string name_;
  StepGraph graph_;
  int runs_;
};

/// Steps of a rotor.
class Steps final : public Subject {
 public:
  Steps(const RotorSize& size, Formulation formulation, int window)
      : name_(fmt::format("rotor {}, {}{}", size.name(), spoke::name_of(formulation),
                          window > 1 ? fmt::format(", window of {}", window) : "")),
        scenario_(paper_rotor(size)),
        formulation_(formulation),
        window_(window) {
    scenario_.integration.duration = 1e9 * scenario_.integration.step;
    scenario_.integration.iterations = 2;  // a turn is the same work at any time
    simulation_ = make(ExecutorKind::serial, 1);
    measure_nodes(*simulation_, 16L * window);  // memory is touched
    const NodeMeasurement warm = measure_nodes(*simulation_, 16L * window);
    runs_per_step_ = warm.runs_per_step;
    const double seconds = graph::work_of(warm.costs) * runs_per_step_;
    steps_ = window * std::max(1L, std::lround(kBatch / (seconds * window)));
  }

  std::string name() const override { return name_; }
  const StepGraph& graph() const override { return simulation_->run_graph(); }
  std::function<void()> turn(ExecutorKind kind, int threads) override {
    const std::shared_ptr<Simulation> simulation = make(kind, threads);
    const auto turn = [simulation, steps = steps_] {
      simulation->run_until(simulation->time() +
                            static_cast<double>(steps) * simulation->step_size());
    };
    if (kind == ExecutorKind::automatic)  // it tunes itself for some tenths of a second
      for (int k = 0; k < 40; ++k) turn();
    return turn;
  }
  NodeMeasurement measure_turn(NodeOrder order) override {
    return measure_nodes(*simulation_, steps_, order);
  }
  double runs_per_turn() const override { return runs_per_step_ * static_cast<double>(steps_); }

 private:
  bool has_window() const override { return window_ > 1; }
  std::unique_ptr<Simulation> make(ExecutorKind kind, int threads) const {
    return std::make_unique<Simulation>(scenario_,
                                        SimulationOptions{formulation_, kind, threads, window_});
  }

  std::string name_;
  Scenario scenario_;
  Formulation formulation_;
  int window_;
  std::unique_ptr<Simulation> simulation_;
  double runs_per_step_ = 1.0;
  long steps_ = 1;
};

/// Of each node.
std::vector<double> median_costs(const std::vector<NodeMeasurement>& turns) {
  std::vector<double> costs(turns.front().costs.size());
  std::vector<double> cost(turns.size());
  for (std::size_t node = 0; node < costs.size(); ++node) {
    for (std::size_t k = 0; k < turns.size(); ++k) cost[k] = turns[k].costs[node];
    costs[node] = graph::median(cost);
  }
  return costs;
}

/// What predictions are made from, turn by turn.
struct MeasuredTurns {
  std::vector<NodeMeasurement> serial, levels;
  std::vector<graph::RuntimeCosts> runtimes;
  double serial_turn = 0.0;       ///< the latest one of the executor serial [s]
  std::vector<double> agreement;  ///< a run by its nodes / by the serial turn of the same round

  void add_serial(NodeMeasurement measured, double runs_per_turn) {
    agreement.push_back((graph::work_of(measured.costs) + measured.between_runs) * runs_per_turn /
                        serial_turn);
    serial.push_back(std::move(measured));
  }
  /// Is called in every round, but takes long.
  void add_runtimes() {
    constexpr int every = 4;
    if (calls_++ % every == 0) runtimes.push_back(graph::measure_runtime_costs());
  }

 private:
  int calls_ = 0;
};

/// A turn behind a pause and a warm-up: threads that still spin after other turns end meanwhile.
Alternative after_pause(std::string name, const std::function<void()>& warm_up,
                        std::function<void()> turn) {
  return {std::move(name), std::move(turn),
          [warm_up] {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            warm_up();
          },
          1.0, 0};
}

struct Configuration {
  ExecutorKind kind;
  int threads;
  std::string name() const { return fmt::format("{} on {}", graph::name_of(kind), threads); }
};

/// Those that can be predicted, whether or not they run the subject's graph.
std::vector<Configuration> configurations_to_predict() {
  std::vector<Configuration> list{{ExecutorKind::serial, 1}};
  for (const ExecutorKind kind :
       {ExecutorKind::flow_graph, ExecutorKind::automatic, ExecutorKind::openmp_levels})
    for (const int threads : {1, 2})
      if (graph::has_executor(kind)) list.push_back({kind, threads});
  return list;
}

/// Turns of a configuration. How fast a flow graph runs depends on where in memory it lies, by some
/// 10 %: several, one after the other.
std::function<void()> make_turns(Subject& subject, const Configuration& configuration) {
  const int places = configuration.kind == ExecutorKind::flow_graph  ? 8
                     : configuration.kind == ExecutorKind::automatic ? 3  // they tune themselves
                                                                     : 1;
  std::vector<std::function<void()>> turns;
  for (int place = 0; place < places; ++place)
    turns.push_back(subject.turn(configuration.kind, configuration.threads));
  // Each twice, for a turn comes behind one that warms up.
  return [turns, calls = std::size_t{0}]() mutable { turns[calls++ / 2 % turns.size()](); };
}

/// The configurations, `serial` first, then the nodes.
std::vector<Alternative> make_alternatives(Subject& subject,
                                           const std::vector<Configuration>& configurations,
                                           MeasuredTurns& turns) {
  std::vector<Alternative> alternatives;
  for (const Configuration& configuration : configurations) {
    const auto turn = std::make_shared<std::function<void()>>(make_turns(subject, configuration));
    const auto next = [turn] { (*turn)(); };
    alternatives.push_back(after_pause(configuration.name(), next, next));
  }
  alternatives.front().run = [turn = alternatives.front().run, &turns] {
    const auto begin = std::chrono::steady_clock::now();
    turn();
    turns.serial_turn =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  alternatives.push_back(after_pause(
      "node by node", [&] { subject.measure_turn(NodeOrder::serial); },
      [&] { turns.add_serial(subject.measure_turn(NodeOrder::serial), subject.runs_per_turn()); }));
  alternatives.push_back(after_pause(
      "node by node, level by level", [&] { subject.measure_turn(NodeOrder::levels); },
      [&] { turns.levels.push_back(subject.measure_turn(NodeOrder::levels)); }));
  alternatives.push_back(after_pause(
      "runtimes", [] {}, [&turns] { turns.add_runtimes(); }));
  return alternatives;
}

/// A line of the report.
std::string describe(const std::string& subject, const graph::RuntimeCosts& runtime) {
  const graph::Overheads& flow_graph = runtime.flow_graph;
  return fmt::format(
      "  {}: a cluster {:.0f} ns, {:.0f} more if spawned; a handover {:.0f} ns; data {:.0f} ns and "
      "{:.2f} a byte; OpenMP barrier of two threads {:.0f} ns",
      subject, flow_graph.per_cluster * 1e9, flow_graph.spawn * 1e9, flow_graph.handover * 1e9,
      runtime.transfer.latency * 1e9, runtime.transfer.per_byte * 1e9, runtime.barrier * 1e9);
}

// Processors change their speed from one second to the next: predictions and measurements are both
// compared with serial runs of the same rounds.
// `on_several` gets predicted / measured of the rows on several threads.
void compare(Subject& subject, const QuestionOptions& options, Table& table, Report& report,
             std::vector<double>& on_several) {
  const auto all = configurations_to_predict();
  auto configurations = all;
  std::erase_if(configurations,
                [&](const Configuration& c) { return !subject.is_run_by(c.kind, c.threads); });
  MeasuredTurns turns;
  const std::vector<Timing> timings =
      measure(make_alternatives(subject, configurations, turns),
              options.quick ? Effort{5, kBatch, 0.5} : Effort{25, kBatch, 4.0});
  const graph::RuntimeCosts runtime = graph::median(turns.runtimes);
  report.add_remark(describe(subject.name(), runtime));
  const graph::RunPredictor predictor(
      subject.graph(), {median_costs(turns.serial), median_costs(turns.levels)}, runtime);
  const double between_runs = turns.serial.back().between_runs;
  const double serial = predictor.work() + between_runs;
  const double agreement = graph::median(turns.agreement);
  std::vector<std::string> row{
      subject.name(), graph::duration_text(timings.front().median / subject.runs_per_turn())};
  for (std::size_t k = 0; const auto& [kind, threads] : all) {
    if (!subject.is_run_by(kind, threads)) {
      row.emplace_back("-");
      continue;
    }
    const double predicted = predictor.predict(kind, threads).expected + between_runs;
    const Timing& timing = timings[k++];
    const double ratio = agreement * (predicted / serial) / timing.ratio;
    row.push_back(figure(ratio));
    report.add_timing(subject.name(), timing);
    if (threads > 1)
      on_several.push_back(ratio);
    else
      report.add_target({fmt::format("predicted / measured, {}, {}", subject.name(), timing.name),
                         ratio, 0.95, 1.05});
  }
  table.rows.push_back(std::move(row));
}

std::vector<std::unique_ptr<Subject>> make_subjects(const QuestionOptions& options) {
  std::vector<std::unique_ptr<Subject>> subjects;
  for (const StepShape& shape : {StepShape{3, 4}, StepShape{24, 8}})
    for (const double node_seconds : {1e-6, 20e-6})
      subjects.push_back(std::make_unique<Synthetic>(shape, node_seconds));
  subjects.push_back(std::make_unique<Steps>(RotorSize{3, 4, 4}, Formulation::structured, 1));
  subjects.push_back(std::make_unique<Steps>(RotorSize{3, 4, 4}, Formulation::structured, 64));
  subjects.push_back(std::make_unique<Steps>(RotorSize{3, 4, 4}, Formulation::subsystem, 1));
  subjects.push_back(std::make_unique<Steps>(RotorSize{3, 4, 4}, Formulation::subsystem, 8));
  if (!options.quick)
    subjects.push_back(std::make_unique<Steps>(RotorSize{24, 8, 8}, Formulation::structured, 1));
  return subjects;
}

}  // namespace

void measure_predict(const QuestionOptions& options, Report& report) {
  Table table{"Predicted / measured time of a run, nodes measured in the same rounds",
              {"model", "serial run"},
              {}};
  for (const Configuration& configuration : configurations_to_predict())
    table.columns.push_back(configuration.name());
  std::vector<double> on_several;
  for (const std::unique_ptr<Subject>& subject : make_subjects(options)) {
    show_progress(subject->name());
    compare(*subject, options, table, report, on_several);
  }
  report.add_table(table);
  const auto near = std::count_if(on_several.begin(), on_several.end(),
                                  [](double ratio) { return std::abs(ratio - 1.0) <= 0.15; });
  report.add_target(at_least("share of rows on two threads within 15 %",
                             static_cast<double>(near) / static_cast<double>(on_several.size()),
                             0.9));
}

}  // namespace spoke::bench
