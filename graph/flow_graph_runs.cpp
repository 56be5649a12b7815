#include "graph/flow_graph_runs.h"

#include <algorithm>
#include <vector>

#include "graph/cost_variation.h"
#include "graph/counting_places.h"
#include "graph/data_traffic.h"
#include "graph/work_stealing.h"

namespace spoke::graph {

int simulated_flow_graph_runs(int clusters) {
  return std::clamp(4000 / std::max(clusters, 1), 4, 64);
}

double simulate_flow_graph_runs(const StepGraph& graph, const Plan& plan,
                                std::span<const double> node_costs, int threads,
                                const RuntimeCosts& runtime, double variation) {
  const int width = level_width(plan);
  if (width <= 1) return work_of(node_costs);  // the executor then does without a flow graph
  const int used_threads = std::min(threads, width);
  DataTraffic traffic(graph, runtime.transfer);
  // Which processor comes first to the place of counting, or finds what another has kept, hangs on
  // nanoseconds: one run of exact costs may be far from the mean.
  CostVariation vary(node_costs, variation);
  Chance chance;
  const std::vector<int> places = counting_places(plan, used_threads);
  const auto makespan = [&] {
    return simulate_work_stealing(plan, vary(), used_threads, runtime.flow_graph, &traffic, &chance,
                                  places)
        .makespan;
  };
  makespan();  // leaves the data where a run finds them
  const int runs = simulated_flow_graph_runs(plan.cluster_count());
  double sum = 0.0;
  for (int k = 0; k < runs; ++k) sum += makespan();
  return sum / runs +
         (used_threads > 1 ? runtime.flow_graph_run_among_threads : runtime.flow_graph_run);
}

}  // namespace spoke::graph
