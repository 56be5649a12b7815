// The question "step_graphs": what two threads gain on graphs shaped like a step, by executor, size
// and cost of a node.

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench/busy_graph.h"
#include "bench/compare/interleaved.h"
#include "bench/openmp_kinds.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "graph/executor.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

using graph::Executor;
using graph::ExecutorKind;
using graph::StepGraph;

constexpr int kThreads = 2;
constexpr double kBatch = 10e-3;  // s, long against waking a thread that slept in others' turns
constexpr std::array kNodeSeconds{0.2e-6, 1e-6, 20e-6};
const std::array kShapes{StepShape{3, 4}, StepShape{3, 16}, StepShape{24, 8}, StepShape{96, 8}};

Effort effort_of(const QuestionOptions& options) {
  return options.quick ? Effort{5, 1e-3, 0.3} : Effort{25, kBatch, 4.0};
}

void settle(Executor& executor) {
  while (executor.tuning()) executor.run();
}

/// Makes an alternative that owns its executor, settled.
Alternative make_alternative(const StepGraph& graph, ExecutorKind kind, int threads) {
  const std::shared_ptr<Executor> executor = graph::make_executor(graph, kind, threads);
  settle(*executor);
  return {std::string(name_of(kind)), [executor] { executor->run(); }, {}, 1.0, 0};
}

/// Adds a pause before an alternative's turn: threads of other runtimes go on spinning for a while
/// after their turn and would take the processor from this one.
Alternative after_pause(const Alternative& plain, double seconds_per_run) {
  const int batch = static_cast<int>(std::clamp(kBatch / seconds_per_run, 1.0, 10000.0));
  Alternative alternative = plain;
  alternative.prepare = [run = plain.run] {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    run();
  };
  alternative.run = [run = plain.run, batch] {
    for (int k = 0; k < batch; ++k) run();
  };
  alternative.scale = 1.0 / batch;
  return alternative;
}

/// Speedups over serial.
struct Speedups {
  std::vector<Timing> timings;
  double of(ExecutorKind kind) const {
    for (const Timing& timing : timings)
      if (timing.name == name_of(kind)) return 1.0 / timing.ratio;
    return 0.0;
  }
};

Speedups measure_speedups(const StepGraph& graph, const QuestionOptions& options) {
  std::vector<Alternative> alternatives;
  for (const ExecutorKind kind :
       {ExecutorKind::serial, ExecutorKind::flow_graph, ExecutorKind::automatic})
    alternatives.push_back(make_alternative(graph, kind, kThreads));
  Speedups speedups{measure(alternatives, effort_of(options))};
  const std::vector<ExecutorKind> others = openmp_kinds();
  if (others.empty()) return speedups;
  for (const ExecutorKind kind : others)
    alternatives.push_back(make_alternative(graph, kind, kThreads));
  const double seconds_per_run = speedups.timings.front().median;
  for (Alternative& alternative : alternatives)
    alternative = after_pause(alternative, seconds_per_run);
  const std::vector<Timing> paused = measure(alternatives, effort_of(options));
  speedups.timings.insert(speedups.timings.end(), paused.begin() + 3, paused.end());
  return speedups;
}

/// Returns the speedup promised for a shape and a cost of nodes; 0: only target A.
double promised(const StepShape& shape, double node_seconds) {
  if (shape.blades == 24) return node_seconds < 1e-6 ? 1.55 : node_seconds < 2e-6 ? 1.85 : 0.0;
  if (shape.blades == 96) return node_seconds < 1e-6 ? 1.70 : 1.93;
  return 0.0;
}

void add_targets(const StepShape& shape, double node_seconds, double speedup, Report& report) {
  const std::string model = shape.name() + ", nodes of " + graph::duration_text(node_seconds);
  report.add_target(at_least("auto is never slower than serial, " + model, speedup, 0.97));
  const double least = promised(shape, node_seconds);
  if (least > 0.0) report.add_target(at_least("auto / serial, " + model, speedup, least));
}

void compare_executors(const QuestionOptions& options, Report& report) {
  std::vector<std::string> columns{"graph", "node", "serial", "flow_graph", "auto"};
  for (const ExecutorKind kind : openmp_kinds()) columns.emplace_back(name_of(kind));
  Table table{"Speedup over serial on 2 threads, nodes of equal cost", std::move(columns), {}};
  for (const StepShape& shape : kShapes) {
    for (const double node_seconds : kNodeSeconds) {
      show_progress(shape.name() + ": tuning");
      const StepGraph graph = make_busy_graph(shape, node_seconds);
      const Speedups speedups = measure_speedups(graph, options);
      std::vector<std::string> row{shape.name(), graph::duration_text(node_seconds)};
      for (const Timing& timing : speedups.timings) {
        const bool first = &timing == &speedups.timings.front();
        row.push_back(first ? graph::duration_text(timing.median) : figure(1.0 / timing.ratio));
        report.add_timing(shape.name() + ", nodes of " + graph::duration_text(node_seconds),
                          timing);
      }
      table.rows.push_back(std::move(row));
      add_targets(shape, node_seconds, speedups.of(ExecutorKind::automatic), report);
    }
  }
  report.add_table(table);
}

/// Measures the cost of an empty node in the flow graph of single nodes on one thread.
void measure_empty_nodes(const QuestionOptions& options, Report& report) {
  const StepGraph graph = make_busy_graph(kShapes[2], 0.0);
  const std::vector<Timing> timings =
      measure({make_alternative(graph, ExecutorKind::serial, 1),
               make_alternative(graph, ExecutorKind::flow_graph, 1)},
              effort_of(options));
  report.add_target(at_most("flow_graph, an empty node on one thread, us",
                            timings[1].median / graph.node_count() * 1e6, 0.15));
}

/// Measures more threads than processors.
void measure_oversubscription(const QuestionOptions& options, Report& report) {
  const std::string graph_name = kShapes[2].name() + ", nodes of 1 us";
  const StepGraph graph = make_busy_graph(kShapes[2], 1e-6);
  for (const ExecutorKind kind : {ExecutorKind::flow_graph, ExecutorKind::automatic}) {
    std::vector<Alternative> alternatives;
    for (const int threads : {kThreads, 6, 12})
      alternatives.push_back(make_alternative(graph, kind, threads));
    const std::vector<Timing> timings = measure(alternatives, effort_of(options));
    const std::string name(name_of(kind));
    report.add_target(at_least(name + ": speed on 6 threads / 2 threads, " + graph_name,
                               1.0 / timings[1].ratio, 0.9));
    report.add_target(at_least(name + ": speed on 12 threads / 2 threads, " + graph_name,
                               1.0 / timings[2].ratio, 0.9));
  }
}

void measure_tuning(Report& report) {
  using Clock = std::chrono::steady_clock;
  const StepGraph graph = make_busy_graph(kShapes[3], 1e-6);
  const auto begin = Clock::now();
  const auto executor = graph::make_executor(graph, ExecutorKind::automatic, kThreads);
  settle(*executor);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  report.add_remark("  auto on " + kShapes[3].name() + ", nodes of 1 us: " + executor->describe());
  report.add_target(at_most(
      "auto: planning and tuning, " + std::to_string(graph.node_count()) + " nodes of 1 us, s",
      seconds, 1.0));
}

}  // namespace

void measure_step_graphs(const QuestionOptions& options, Report& report) {
  compare_executors(options, report);
  measure_empty_nodes(options, report);
  measure_oversubscription(options, report);
  measure_tuning(report);
}

}  // namespace spoke::bench
