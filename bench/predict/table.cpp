// The rows of the table and the facts above it.

#include "bench/predict/table.h"

#include <spdlog/fmt/fmt.h>

#include "graph/machine/duration_text.h"
#include "models/count_text.h"
#include "program/report/markup.h"

namespace spoke::predict {
namespace {

std::string microseconds(double seconds) { return fmt::format("{:.4g}", seconds * 1e6); }

report::Row row_of(const Prediction& prediction, ExecutorKind executor, const Point& point) {
  std::vector<std::string> cells{
      std::string(graph::name_of(executor)),
      std::to_string(point.threads),
      std::to_string(point.window),
      microseconds(point.step.expected),
      microseconds(point.step.optimistic) + "-" + microseconds(point.step.pessimistic),
      report::ratio_text(prediction.speedup(point)),
      point.step.clusters > 0 ? std::to_string(point.step.clusters) : "-"};
  if (point.measured) {
    cells.push_back(microseconds(point.measured->step.median));
    cells.push_back(report::ratio_text(point.measured->speedup.median));
    cells.push_back(fmt::format("{:+.1f} %", 100.0 * *point.error()));
  } else {
    cells.insert(cells.end(), 3, "");
  }
  const auto bound = bound_at_capacity(prediction, executor, point);
  cells.push_back(bound ? microseconds(*bound) : "");
  return {std::move(cells)};
}

/// Adds facts of a graph: its size, the time of a step, and the costs of its nodes. `whose`: a
/// run's, auto's.
void add_run(const RunGraph& run, const std::string& whose, std::vector<report::Fact>& facts) {
  const NodeMeasurement& nodes = run.nodes.serial;
  facts.emplace_back("graph of " + whose,
                     fmt::format("{}, {}, for {}", counted(run.node_count, "node"),
                                 counted(run.edge_count, "edge"), describe_runs(run)));
  facts.emplace_back(
      "a step",
      fmt::format("{:.4g} run{}; T1 = {}, Tinf = {}, T1 / Tinf = {:.2f}", nodes.runs_per_step,
                  nodes.runs_per_step == 1.0 ? "" : "s", graph::duration_text(run.work),
                  graph::duration_text(run.span), run.parallelism()));
  facts.emplace_back("nodes",
                     fmt::format("timed in {}, spread {:.3f} to {:.3f}, {} between "
                                 "two runs",
                                 counted(run.nodes.steps, "step"), run.nodes.spread.low,
                                 run.nodes.spread.high, graph::duration_text(nodes.between_runs)));
}

}  // namespace

report::Table make_table(const Prediction& prediction) {
  using report::Align;
  report::Table table{"Predicted and measured time per step",
                      {{"executor"},
                       {"threads", Align::number},
                       {"window", Align::number},
                       {"predicted [us]", Align::number},
                       {"band [us]", Align::number},
                       {"speedup", Align::number},
                       {"clusters", Align::number},
                       {"measured [us]", Align::number},
                       {"speedup", Align::number},
                       {"error", Align::number},
                       {"bound at capacity [us]", Align::number}}};
  table.rows.push_back(row_of(prediction, ExecutorKind::serial, prediction.serial));
  for (const Series& series : prediction.series)
    for (const Point& point : series.points)
      table.rows.push_back(row_of(prediction, series.executor, point));
  return table;
}

report::Table make_rank_table(const Prediction& prediction) {
  using report::Align;
  report::Table table{"Predicted time per step on several processes of one thread",
                      {{"processes", Align::number},
                       {"predicted [us]", Align::number},
                       {"of it network [us]", Align::number},
                       {"speedup", Align::number}}};
  for (const RankPoint& point : prediction.ranks)
    table.rows.push_back(
        {{std::to_string(point.ranks), microseconds(point.step()), microseconds(point.telling),
          report::ratio_text(prediction.speedup(point))}});
  return table;
}

std::vector<report::Fact> make_facts(const Prediction& prediction) {
  const graph::RuntimeCosts& runtime = prediction.runtime;
  const auto& flow_graph = runtime.flow_graph;
  std::vector<report::Fact> facts{
      {"solved by",
       fmt::format("{}, {}, step {:.6g} s", name_of(prediction.formulation),
                   name_of(prediction.scenario.integration.method), prediction.step_size)}};
  if (prediction.capacity.is_known()) facts.emplace_back("capacity", prediction.capacity.text());
  add_run(prediction.run, "a run", facts);
  if (prediction.auto_run) add_run(*prediction.auto_run, "auto", facts);
  facts.emplace_back("flow graph", fmt::format("{} a cluster, {} a handover to another thread",
                                               graph::duration_text(flow_graph.per_cluster),
                                               graph::duration_text(flow_graph.handover)));
  if (!prediction.ranks.empty())
    facts.emplace_back("network",
                       fmt::format("{} a message between processes, {}",
                                   graph::duration_text(prediction.network.latency),
                                   prediction.network.is_measured ? "measured" : "not measured"));
  if (runtime.barrier > 0.0)
    facts.emplace_back("OpenMP", graph::duration_text(runtime.barrier) +
                                     " a barrier of two threads, " +
                                     graph::duration_text(runtime.barrier_alone) + " of one");
  return facts;
}

}  // namespace spoke::predict
