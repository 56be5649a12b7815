// Cuts the depth-first order into stretches with few edges across.

#include "graph/plan/flow_graph_partition.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "graph/structure/depth_first_order.h"
#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

// Counts the edges that lead from before the k-th of `order` to it or behind it.
std::vector<int> edges_across(const Plan& plan, const std::vector<int>& order) {
  std::vector<std::size_t> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[index_of(order[k])] = k;
  std::vector<int> across(order.size() + 1, 0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const int next : plan.successors(order[k])) {
      ++across[k + 1];
      --across[position[index_of(next)] + 1];
    }
  }
  for (std::size_t k = 1; k < across.size(); ++k) across[k] += across[k - 1];
  return across;
}

// Returns where the flow graphs' stretches of an order begin: they are about equally long, cut
// where the fewest edges lead across. Last comes the end.
std::vector<std::size_t> cut(const std::vector<int>& across, std::size_t flows) {
  const std::size_t count = across.size() - 1;
  const auto slack = static_cast<std::ptrdiff_t>(count / flows / 4);
  std::vector<std::size_t> begins{0};
  for (std::size_t flow = 1; flow < flows; ++flow) {
    const auto middle = across.begin() + static_cast<std::ptrdiff_t>(count * flow / flows);
    const auto fewest = std::min_element(middle - slack, middle + slack + 1);
    begins.push_back(static_cast<std::size_t>(fewest - across.begin()));
  }
  begins.push_back(count);
  return begins;
}

}  // namespace

std::vector<int> partition_clusters(const Plan& plan, int threads) {
  assert(threads >= 1);
  // More of them are no faster, and with fewer threads meet more often.
  constexpr int clusters_per_flow = 16, flows_per_thread = 4;
  const int count = plan.cluster_count();
  std::vector<int> flow_of(index_of(count), 0);
  const int used =
      threads == 1 ? 1 : std::clamp(count / clusters_per_flow, 1, flows_per_thread * threads);
  if (used == 1) return flow_of;
  const auto order = depth_first_order<int>(
      count, [&](int c) { return plan.predecessors(c); },
      [&](int c) { return plan.successors(c); });
  const std::vector<std::size_t> begins = cut(edges_across(plan, order), index_of(used));
  for (int flow = 0; flow < used; ++flow) {
    for (std::size_t k = begins[index_of(flow)]; k < begins[index_of(flow + 1)]; ++k)
      flow_of[index_of(order[k])] = flow;
  }
  return flow_of;
}

}  // namespace spoke::graph
