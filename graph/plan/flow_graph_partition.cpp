// Cuts the depth-first order into stretches with few edges across.

#include "graph/plan/flow_graph_partition.h"

#include <algorithm>
#include <cstddef>

#include "graph/structure/depth_first_order.h"
#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

// How many edges lead from before the k-th of `order` to it or behind it.
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

// Where the parts of an order begin whose clusters are counted together: about equally many each,
// cut where the fewest edges lead across. Last comes the end.
std::vector<std::size_t> cut(const std::vector<int>& across, std::size_t parts) {
  const std::size_t count = across.size() - 1;
  const auto slack = static_cast<std::ptrdiff_t>(count / parts / 4);
  std::vector<std::size_t> begins{0};
  for (std::size_t part = 1; part < parts; ++part) {
    const auto middle = across.begin() + static_cast<std::ptrdiff_t>(count * part / parts);
    const auto fewest = std::min_element(middle - slack, middle + slack + 1);
    begins.push_back(static_cast<std::size_t>(fewest - across.begin()));
  }
  begins.push_back(count);
  return begins;
}

}  // namespace

std::vector<int> counting_places(const Plan& plan, int threads) {
  // More of them are no faster, and with fewer threads meet more often.
  constexpr int clusters_per_place = 16, places_per_thread = 4;
  const int count = plan.cluster_count();
  std::vector<int> places(index_of(count), 0);
  const int used =
      threads == 1 ? 1 : std::clamp(count / clusters_per_place, 1, places_per_thread * threads);
  if (used == 1) return places;
  const auto order = depth_first_order<int>(
      count, [&](int c) { return plan.predecessors(c); },
      [&](int c) { return plan.successors(c); });
  const std::vector<std::size_t> begins = cut(edges_across(plan, order), index_of(used));
  for (int place = 0; place < used; ++place) {
    for (std::size_t k = begins[index_of(place)]; k < begins[index_of(place + 1)]; ++k)
      places[index_of(order[k])] = place;
  }
  return places;
}

}  // namespace spoke::graph
