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
#include "graph/measuring_executor.h"
#include "graph/run_prediction.h"

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
  /// What makes a turn with an executor, settled.
  virtual std::function<void()> turn(ExecutorKind kind, int threads) = 0;
  /// Makes a turn on one thread and measures the nodes.
  virtual void measure_turn(NodeOrder order) = 0;
  /// Over the measured turns, per run [s].
  virtual graph::OrderedCosts node_costs() const = 0;
  virtual double between_runs() const = 0;
  virtual double runs_per_turn() const = 0;
};

/// A graph of busy nodes.
class Synthetic final : public Subject {
 public:
  Synthetic(const StepShape& shape, double node_seconds)
      : name_(shape.name() + ", nodes of " + duration(node_seconds)),
        graph_(make_busy_graph(shape, node_seconds)),
        serial_(graph_),
        levels_(graph_, NodeOrder::levels),
        runs_(static_cast<int>(std::max(1.0, kBatch / (node_seconds * graph_.node_count())))) {}

  std::string name() const override { return name_; }
  const StepGraph& graph() const override { return graph_; }
  std::function<void()> turn(ExecutorKind kind, int threads) override {
    const std::shared_ptr<Executor> executor = graph::make_executor(graph_, kind, threads);
    while (executor->tuning()) executor->run();
    return [executor, runs = runs_] { run_repeatedly(*executor, runs); };
  }
  void measure_turn(NodeOrder order) override {
    run_repeatedly(order == NodeOrder::serial ? serial_ : levels_, runs_);
  }
  graph::OrderedCosts node_costs() const override {
    return {serial_.node_costs(), levels_.node_costs()};
  }
  double between_runs() const override { return serial_.between_runs(); }
  double runs_per_turn() const override { return runs_; }

 private:
  static void run_repeatedly(Executor& executor, int runs) {
    int left = runs;
    executor.run_while([&left] { return --left > 0; });
  }

  std::string name_;
  StepGraph graph_;
  graph::MeasuringExecutor serial_, levels_;
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
    simulation_ = make(ExecutorKind::serial, 1);
    simulation_->measure_nodes(16L * window);  // memory is touched
    const NodeMeasurement warm = simulation_->measure_nodes(16L * window);
    const double seconds = graph::work_of(warm.costs) * warm.runs_per_step;
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
  void measure_turn(NodeOrder order) override {
    turns_of(order).push_back(simulation_->measure_nodes(steps_, order));
  }
  graph::OrderedCosts node_costs() const override { return {medians(serial_), medians(levels_)}; }
  double between_runs() const override { return serial_.back().between_runs; }
  double runs_per_turn() const override {
    return serial_.back().runs_per_step * static_cast<double>(steps_);
  }

 private:
  static std::vector<double> medians(const std::vector<NodeMeasurement>& turns) {
    std::vector<double> costs(turns.front().costs.size());
    std::vector<double> cost(turns.size());
    for (std::size_t node = 0; node < costs.size(); ++node) {
      for (std::size_t k = 0; k < turns.size(); ++k) cost[k] = turns[k].costs[node];
      const auto middle = cost.begin() + static_cast<std::ptrdiff_t>(cost.size() / 2);
      std::nth_element(cost.begin(), middle, cost.end());
      costs[node] = *middle;
    }
    return costs;
  }
  std::vector<NodeMeasurement>& turns_of(NodeOrder order) {
    return order == NodeOrder::serial ? serial_ : levels_;
  }
  std::unique_ptr<Simulation> make(ExecutorKind kind, int threads) const {
    return std::make_unique<Simulation>(scenario_,
                                        SimulationOptions{formulation_, kind, threads, window_});
  }

  std::string name_;
  Scenario scenario_;
  Formulation formulation_;
  int window_;
  std::unique_ptr<Simulation> simulation_;
  long steps_ = 1;
  std::vector<NodeMeasurement> serial_, levels_;  // per turn
};

/// A turn behind a pause and a warm-up: threads that still spin after other turns end meanwhile.
Alternative after_pause(std::string name, std::function<void()> turn) {
  return {std::move(name), turn,
          [turn] {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            turn();
          },
          1.0, 0};
}

struct Configuration {
  ExecutorKind kind;
  int threads;
  std::string name() const { return fmt::format("{} on {}", graph::name_of(kind), threads); }
};

std::vector<Configuration> configurations_of(const StepGraph& graph) {
  const std::vector<double> costs(static_cast<std::size_t>(graph.node_count()));
  const graph::RunPredictor predictor(graph, {costs, costs}, graph::runtime_costs());
  std::vector<Configuration> list{{ExecutorKind::serial, 1}};
  for (const ExecutorKind kind :
       {ExecutorKind::flow_graph, ExecutorKind::automatic, ExecutorKind::openmp_levels})
    for (const int threads : {1, 2})
      if (predictor.can_predict(kind)) list.push_back({kind, threads});
  return list;
}

void compare(Subject& subject, const QuestionOptions& options, Table& table, Report& report) {
  const graph::RuntimeCosts& runtime = graph::runtime_costs();
  const auto configurations = configurations_of(subject.graph());
  std::vector<Alternative> alternatives;
  for (const Configuration& configuration : configurations)
    alternatives.push_back(
        after_pause(configuration.name(), subject.turn(configuration.kind, configuration.threads)));
  for (const NodeOrder order : {NodeOrder::serial, NodeOrder::levels})
    alternatives.push_back(
        after_pause(order == NodeOrder::serial ? "node by node" : "node by node, level by level",
                    [&subject, order] { subject.measure_turn(order); }));
  const std::vector<Timing> timings =
      measure(alternatives, options.quick ? Effort{5, kBatch, 0.5} : Effort{25, kBatch, 4.0});
  const graph::RunPredictor predictor(subject.graph(), subject.node_costs(), runtime);
  const double serial = timings.front().median / subject.runs_per_turn();
  std::vector<std::string> row{subject.name(), duration(serial)};
  for (std::size_t k = 0; k < configurations.size(); ++k) {
    const auto [kind, threads] = configurations[k];
    const double predicted = predictor.predict(kind, threads).expected + subject.between_runs();
    const double ratio = predicted / (serial * timings[k].ratio);
    row.push_back(figure(ratio));
    report.add_timing(subject.name(), timings[k]);
    const double margin = threads == 1 ? 0.05 : 0.10;
    report.add_target(
        {fmt::format("predicted / measured, {}, {}", subject.name(), configurations[k].name()),
         ratio, 1.0 - margin, 1.0 + margin});
  }
  table.rows.push_back(std::move(row));
}

std::vector<std::unique_ptr<Subject>> make_subjects(const QuestionOptions& options) {
  std::vector<std::unique_ptr<Subject>> subjects;
  for (const StepShape& shape : {StepShape{3, 4}, StepShape{24, 8}})
    for (const double node_seconds : {1e-6, 20e-6})
      subjects.push_back(std::make_unique<Synthetic>(shape, node_seconds));
  subjects.push_back(std::make_unique<Steps>(RotorSize{3, 4, 4}, Formulation::structured, 1));
  subjects.push_back(std::make_unique<Steps>(RotorSize{3, 4, 4}, Formulation::subsystem, 1));
  subjects.push_back(std::make_unique<Steps>(RotorSize{3, 4, 4}, Formulation::subsystem, 8));
  if (!options.quick)
    subjects.push_back(std::make_unique<Steps>(RotorSize{24, 8, 8}, Formulation::structured, 1));
  return subjects;
}

}  // namespace

void measure_predict(const QuestionOptions& options, Report& report) {
  const graph::RuntimeCosts& runtime = graph::runtime_costs();
  report.add_remark(fmt::format(
      "  flow graph: {} a cluster and up to {} more among threads, {} a handover, {} a run; OpenMP "
      "barrier of two threads: {}; data {} and {:.3g} ns a byte",
      duration(runtime.flow_graph.per_cluster), duration(runtime.contention),
      duration(runtime.flow_graph.handover), duration(runtime.flow_graph_run),
      duration(runtime.barrier), duration(runtime.transfer.latency),
      runtime.transfer.per_byte * 1e9));
  Table table{"Predicted / measured time of a run, nodes measured in the same rounds",
              {"model", "serial run"},
              {}};
  for (const std::unique_ptr<Subject>& subject : make_subjects(options)) {
    show_progress(subject->name());
    if (table.columns.size() == 2)
      for (const Configuration& configuration : configurations_of(subject->graph()))
        table.columns.push_back(configuration.name());
    compare(*subject, options, table, report);
  }
  report.add_table(table);
}

}  // namespace spoke::bench
