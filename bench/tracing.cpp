#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bench/busy_graph.h"
#include "bench/interleaved.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "graph/executor.h"
#include "graph/node_recorder.h"

namespace spoke::bench {
namespace {

using graph::Executor;
using graph::ExecutorKind;
using graph::NodeId;
using graph::NodeRecorder;
using graph::StepGraph;

constexpr std::array kNodeSeconds{0.2e-6, 1e-6};
const std::array kShapes{StepShape{3, 4}, StepShape{24, 8}};

Effort effort_of(const QuestionOptions& options) {
  return options.quick ? Effort{5, 1e-3, 0.3} : Effort{101, 2e-3, 3.0};
}

/// What the serial executor was before it could record.
Alternative make_plain_loop(const StepGraph& graph) {
  return {"loop without recorder",
          [&graph] {
            for (const NodeId node : graph.serial_order()) graph.run_node(node);
          },
          {},
          1.0,
          0};
}

Alternative make_silent(const StepGraph& graph, ExecutorKind kind, int threads, int reference) {
  const std::shared_ptr<Executor> executor = graph::make_executor(graph, kind, threads);
  return {
      std::string(name_of(kind)) + ", off", [executor] { executor->run(); }, {}, 1.0, reference};
}

/// Records every run; what was recorded is forgotten when there is no room left.
Alternative make_recorded(const StepGraph& graph, ExecutorKind kind, int threads, int reference) {
  constexpr std::size_t runs = 20, most_bytes = std::size_t{64} << 20;
  const std::shared_ptr<Executor> executor = graph::make_executor(graph, kind, threads);
  const int lanes = executor->threads().total();
  const auto recorder = std::make_shared<NodeRecorder>(
      lanes, graph.node_count(), graph::make_room(runs, graph.node_count(), lanes, most_bytes));
  executor->set_recorder(recorder.get());
  const auto run = [executor, recorder] {
    if (!recorder->begin_run()) {
      recorder->clear();
      recorder->begin_run();
    }
    executor->run();
    recorder->end_run();
  };
  return {std::string(name_of(kind)) + ", on", run, {}, 1.0, reference};
}

std::vector<Alternative> make_alternatives(const StepGraph& graph) {
  return {make_plain_loop(graph),
          make_silent(graph, ExecutorKind::serial, 1, 0),
          make_recorded(graph, ExecutorKind::serial, 1, 1),
          make_silent(graph, ExecutorKind::flow_graph, 1, 3),
          make_recorded(graph, ExecutorKind::flow_graph, 1, 3),
          make_silent(graph, ExecutorKind::flow_graph, 2, 5),
          make_recorded(graph, ExecutorKind::flow_graph, 2, 5)};
}

std::string cost(const Timing& timing) { return figure(100.0 * (timing.ratio - 1.0)) + " %"; }

void add_targets(const std::string& model, double node_seconds, const std::vector<Timing>& timings,
                 Report& report) {
  report.add_target(
      at_most("tracing off: serial / loop that cannot record, " + model, timings[1].ratio, 1.02));
  if (node_seconds < 1e-6) return;
  report.add_target(at_most("tracing on / off: serial, " + model, timings[2].ratio, 1.05));
  report.add_target(
      at_most("tracing on / off: flow_graph on 1 thread, " + model, timings[4].ratio, 1.05));
  report.add_target(
      at_most("tracing on / off: flow_graph on 2 threads, " + model, timings[6].ratio, 1.05));
}

}  // namespace

void measure_tracing(const QuestionOptions& options, Report& report) {
  Table table{"What tracing costs, of a run",
              {"graph", "node", "loop", "serial off", "serial on", "flow 1 on", "flow 2 on"},
              {}};
  for (const StepShape& shape : kShapes)
    for (const double node_seconds : kNodeSeconds) {
      const std::string model = shape.name() + ", nodes of " + duration(node_seconds);
      show_progress(model);
      const StepGraph graph = make_busy_graph(shape, node_seconds);
      const std::vector<Timing> timings = measure(make_alternatives(graph), effort_of(options));
      for (const Timing& timing : timings) report.add_timing(model, timing);
      table.rows.push_back({shape.name(), duration(node_seconds), duration(timings[0].median),
                            cost(timings[1]), cost(timings[2]), cost(timings[4]),
                            cost(timings[6])});
      add_targets(model, node_seconds, timings, report);
    }
  report.add_table(table);
  report.add_remark(
      "  off: against a loop without a recorder's branch; on: against the same executor, off");
}

}  // namespace spoke::bench
