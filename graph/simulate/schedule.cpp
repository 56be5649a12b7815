// Computes work, span, and the times of clusters.

#include "graph/simulate/schedule.h"

#include <algorithm>
#include <numeric>

#include "graph/structure/index_of.h"

namespace spoke::graph {

std::vector<double> cluster_times(const Plan& plan, std::span<const double> node_costs,
                                  const Overheads& overheads) {
  std::vector<double> times = cluster_costs(plan, node_costs);
  for (int c = 0; c < plan.cluster_count(); ++c) {
    times[index_of(c)] +=
        overheads.per_cluster + overheads.per_node * static_cast<double>(plan.nodes(c).size());
  }
  return times;
}

double work_of(std::span<const double> node_costs) {
  return std::accumulate(node_costs.begin(), node_costs.end(), 0.0);
}

double span_of(const Plan& plan, std::span<const double> node_costs) {
  // The cost, per cluster, of the costliest path that begins with it.
  std::vector<double> levels = cluster_costs(plan, node_costs);
  for (int c = plan.cluster_count(); c-- > 0;) {
    double longest = 0.0;
    for (const int next : plan.successors(c)) longest = std::max(longest, levels[index_of(next)]);
    levels[index_of(c)] += longest;
  }
  return levels.empty() ? 0.0 : *std::max_element(levels.begin(), levels.end());
}

}  // namespace spoke::graph
