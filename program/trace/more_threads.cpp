// Gives the nodes of a run the costs of their slices, and simulates the run.

#include "program/trace/more_threads.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <string_view>
#include <tuple>

#include "graph/calibrate/quantiles.h"
#include "graph/structure/index_of.h"
#include "graph/tune/run_prediction.h"

namespace spoke::trace {
namespace {

using graph::index_of;

/// What tells nodes of one pass apart.
using NodeKey = std::tuple<std::string_view, int, int, std::string_view>;

NodeKey key_of(const graph::NodeLabel& label) {
  return {label.stage, label.subsystem, label.body, label.item};
}

/// Returns by node of a pass the robust mean of its slices [s]; 0 without any.
std::vector<double> costs_of_pass(const StepTrace& trace) {
  std::vector<std::vector<double>> durations(trace.graph.labels.size());
  for (const NodeSlice& slice : trace.slices)
    durations[index_of(slice.node)].push_back(1e-9 * static_cast<double>(slice.end - slice.begin));
  std::vector<double> costs;
  for (std::vector<double>& samples : durations)
    costs.push_back(samples.empty() ? 0.0 : graph::robust_mean(samples));
  return costs;
}

double passes_per_step(const StepTrace& trace) {
  double passes = 0.0;
  for (const TracedStep& step : trace.steps) passes += step.passes;
  return passes / static_cast<double>(trace.steps.size());
}

int count_passes(const graph::StepGraph& run) {
  int last = 0;
  for (const graph::Node& node : run.nodes()) last = std::max(last, node.label.pass);
  return last + 1;
}

}  // namespace

std::vector<double> costs_of_run(const StepTrace& trace, const graph::StepGraph& run) {
  const std::vector<double> of_pass = costs_of_pass(trace);
  std::map<NodeKey, double> cost_of;
  for (std::size_t node = 0; node < of_pass.size(); ++node)
    cost_of[key_of(trace.graph.labels[node])] = of_pass[node];
  std::vector<double> costs;
  costs.reserve(index_of(run.node_count()));
  for (const graph::Node& node : run.nodes()) costs.push_back(cost_of[key_of(node.label)]);
  return costs;
}

MoreThreads find_more_threads(const StepTrace& trace, const graph::StepGraph& run, int window_steps,
                              const std::vector<int>& threads) {
  assert(!trace.steps.empty());
  const graph::RunPredictor predictor(run, costs_of_run(trace, run));
  MoreThreads found{.window_steps = window_steps, .passes = count_passes(run)};
  const double runs_per_step = passes_per_step(trace) / found.passes;
  found.work = runs_per_step * predictor.work();
  found.span = runs_per_step * predictor.span();
  for (const int count : threads) {
    const graph::AutoRun by_auto = predictor.choose(count);
    found.rows.push_back({.threads = count,
                          .scheduled = runs_per_step * predictor.schedule(count, {0.0, 0.0, 0.0}),
                          .by_auto = runs_per_step * by_auto.seconds,
                          .clusters = by_auto.clusters});
  }
  return found;
}

}  // namespace spoke::trace
