#include "graph/counting_places.h"

#include <algorithm>
#include <cstddef>

#include "graph/depth_first_order.h"

namespace spoke::graph {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// How many edges lead from before the k-th of `order` to it or behind it.
std::vector<int> edges_across(const Plan& plan, const std::vector<int>& order) {
  std::vector<std::size_t> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[at(order[k])] = k;
  std::vector<int> across(order.size() + 1, 0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const int next : plan.successors(order[k])) {
      ++across[k + 1];
      --across[position[at(next)] + 1];
    }
  }
  for (std::size_t k = 1; k < across.size(); ++k) across[k] += across[k - 1];
  return across;
}

}  // namespace

std::vector<int> counting_places(const Plan& plan, int threads) {
  // More of them are no faster, and with fewer threads meet more often.
  constexpr int clusters_per_place = 16, places_per_thread = 4;
  const int count = plan.cluster_count();
  std::vector<int> places(at(count), 0);
  const int used =
      threads == 1 ? 1 : std::clamp(count / clusters_per_place, 1, places_per_thread * threads);
  if (used == 1) return places;
  const auto order = depth_first_order<int>(
      count, [&](int c) { return plan.predecessors(c); },
      [&](int c) { return plan.successors(c); });
  const std::vector<int> across = edges_across(plan, order);
  std::size_t begin = 0;
  for (int place = 0; place < used; ++place) {
    std::size_t end = order.size();
    if (place + 1 < used) {
      // About equally many, cut where the fewest edges are.
      const std::size_t share = order.size() / at(used);
      const std::size_t middle = order.size() * at(place + 1) / at(used);
      const auto first = across.begin() + static_cast<std::ptrdiff_t>(middle - share / 4);
      const auto last = across.begin() + static_cast<std::ptrdiff_t>(middle + share / 4 + 1);
      end = static_cast<std::size_t>(std::min_element(first, last) - across.begin());
    }
    for (; begin < end; ++begin) places[at(order[begin])] = place;
  }
  return places;
}

}  // namespace spoke::graph
