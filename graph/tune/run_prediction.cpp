// Predicted times of each executor, from the costs of nodes and of the runtime.

#include "graph/tune/run_prediction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "graph/plan/level_rounds.h"
#include "graph/simulate/work_stealing.h"
#include "graph/structure/index_of.h"
#include "graph/tune/plan_candidates.h"

namespace spoke::graph {
namespace {

// Counts the barriers of a pass, with those around the question whether to go on, which the first
// thread asks between two passes.
double barriers_of(const std::vector<Round>& rounds) {
  return static_cast<double>(rounds.size()) - 1.0 + (ends_alone(rounds) ? 1.0 : 2.0);
}

// Returns the time of a run of the flow graph [s].
double seconds_of_plan(const Plan& plan, const std::vector<double>& costs, int threads,
                       const Overheads& overheads) {
  const int width = level_width(plan);
  if (width <= 1) return work_of(costs);  // the executor then does without a flow graph
  return simulate_work_stealing(plan, costs, std::min(threads, width), overheads).makespan;
}

// Returns the sum over the rounds of the costliest thread's share [s].
double critical_shares(const std::vector<Round>& rounds, const std::vector<double>& costs) {
  double seconds = 0.0;
  for (const Round& round : rounds) {
    double most = 0.0;
    for (const auto& nodes : round) {
      double share = 0.0;
      for (const NodeId node : nodes) share += costs[index_of(node)];
      most = std::max(most, share);
    }
    seconds += most;
  }
  return seconds;
}

}  // namespace

RunPredictor::RunPredictor(const StepGraph& graph, std::vector<double> node_costs,
                           const RuntimeCosts& runtime, CostSpread spread)
    : graph_(graph),
      node_costs_(std::move(node_costs)),
      runtime_(runtime),
      spread_(spread),
      single_nodes_(plan_of_single_nodes(graph)) {}

double RunPredictor::work() const { return work_of(node_costs_); }
double RunPredictor::span() const { return span_of(single_nodes_, node_costs_); }

bool RunPredictor::can_predict(ExecutorKind kind) const {
  if (kind == ExecutorKind::openmp_levels) return runtime_.barrier > 0.0;
  return kind == ExecutorKind::serial || kind == ExecutorKind::flow_graph ||
         kind == ExecutorKind::automatic;
}

PredictedRun RunPredictor::predict(ExecutorKind kind, int threads) const {
  assert(can_predict(kind) && threads >= 1);
  switch (kind) {
    case ExecutorKind::serial:
      return predict_serial();
    case ExecutorKind::flow_graph:
      return predict_plan(single_nodes_, threads);
    case ExecutorKind::automatic:
      return predict_auto(threads);
    case ExecutorKind::openmp_levels:
      return predict_levels(threads);
    default:
      throw std::invalid_argument("no prediction of " + std::string(name_of(kind)));
  }
}

PredictedRun RunPredictor::within_bounds(double seconds, int threads, int clusters) const {
  const double share = work() / threads;
  const double greedy = share + (1.0 - 1.0 / threads) * span();
  return {seconds, std::min(seconds, spread_.low * std::max(share, span())),
          std::max(seconds, spread_.high * greedy), clusters};
}

PredictedRun RunPredictor::predict_serial() const { return within_bounds(work(), 1, 1); }

PredictedRun RunPredictor::predict_plan(const Plan& plan, int threads) const {
  return within_bounds(seconds_of_plan(plan, node_costs_, threads, runtime_.flow_graph), threads,
                       plan.cluster_count());
}

PredictedRun RunPredictor::predict_auto(int threads) const {
  const PredictedRun serial = predict_serial();
  if (threads == 1) return serial;
  const double worth_while =
      serial.expected / least_gain(serial.expected, runtime_.flow_graph.handover);
  PredictedRun best = serial;
  for (const Candidate& candidate :
       find_candidates(graph_, node_costs_, threads, runtime_.flow_graph, 3)) {
    const PredictedRun run = predict_plan(candidate.plan, threads);
    if (run.expected < std::min(best.expected, worth_while)) best = run;
  }
  best.pessimistic = std::min(best.pessimistic, serial.pessimistic);  // it would notice
  return best;
}

// Predicts levels by barriers that are trees of threads, whose cost grows with the logarithm of
// their number.
PredictedRun RunPredictor::predict_levels(int threads) const {
  const std::vector<Round> rounds = derive_level_rounds(graph_, threads);
  const double barrier =
      threads == 1 ? runtime_.barrier_alone : runtime_.barrier * std::log2(threads);
  const double shares = critical_shares(rounds, node_costs_);
  return within_bounds(shares + barriers_of(rounds) * barrier, threads, 0);
}

}  // namespace spoke::graph
