// Simulates runs of single nodes, and of the plans that the executor auto makes.

#include "graph/tune/run_prediction.h"

#include <cassert>
#include <utility>

#include "graph/simulate/work_stealing.h"
#include "graph/tune/plan_candidates.h"

namespace spoke::graph {

RunPredictor::RunPredictor(const StepGraph& graph, std::vector<double> node_costs)
    : graph_(graph),
      node_costs_(std::move(node_costs)),
      single_nodes_(plan_of_single_nodes(graph)) {}

double RunPredictor::work() const { return work_of(node_costs_); }
double RunPredictor::span() const { return span_of(single_nodes_, node_costs_); }

double RunPredictor::schedule(int processors, const Overheads& overheads) const {
  assert(processors >= 1);
  return simulate_work_stealing(single_nodes_, node_costs_, processors, overheads).makespan;
}

AutoRun RunPredictor::choose(int threads) const {
  assert(threads >= 1);
  const AutoRun serial{work(), 1};
  if (threads == 1) return serial;
  const Overheads overheads;  // those that auto goes by
  const auto fastest = find_candidates(graph_, node_costs_, threads, overheads, 1);
  const double acceptable = serial.seconds / least_gain(serial.seconds, overheads.handover);
  if (fastest.empty() || fastest.front().makespan > acceptable) return serial;
  return {fastest.front().makespan, fastest.front().plan.cluster_count()};
}

}  // namespace spoke::graph
