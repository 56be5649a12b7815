// Finds chains and their groups, cuts them into shares, and adds the edges that hold an order.

#include "graph/simulate/schedule_order.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "graph/plan/coarsening.h"
#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

using Chain = std::vector<int>;         // clusters, each the only successor of the one before
using ChainGroup = std::vector<Chain>;  // between the same predecessors and successors

std::vector<Chain> find_chains(const Plan& plan) {
  std::vector<Chain> chains;
  std::vector<std::size_t> chain_of(index_of(plan.cluster_count()));
  for (int c = 0; c < plan.cluster_count(); ++c) {
    const auto before = plan.predecessors(c);
    if (before.size() == 1 && plan.successors(before[0]).size() == 1) {
      chain_of[index_of(c)] = chain_of[index_of(before[0])];
    } else {
      chain_of[index_of(c)] = chains.size();
      chains.emplace_back();
    }
    chains[chain_of[index_of(c)]].push_back(c);
  }
  return chains;
}

// In the order of their first clusters, which is a topological order of the groups.
std::vector<ChainGroup> find_groups(const Plan& plan) {
  std::vector<ChainGroup> groups;
  std::map<std::vector<int>, std::size_t> group_of;
  for (Chain& chain : find_chains(plan)) {
    const auto before = plan.predecessors(chain.front());
    const auto after = plan.successors(chain.back());
    std::vector<int> key(before.begin(), before.end());
    key.push_back(-1);
    key.insert(key.end(), after.begin(), after.end());
    const auto [entry, is_new] = group_of.emplace(std::move(key), groups.size());
    if (is_new) groups.emplace_back();
    groups[entry->second].push_back(std::move(chain));
  }
  return groups;
}

double sum_over(const Chain& chain, const std::vector<double>& costs) {
  return std::accumulate(chain.begin(), chain.end(), 0.0,
                         [&](double sum, int c) { return sum + costs[index_of(c)]; });
}

// How many of the chain's first clusters to leave to the next processor, so that the rest fits
// best into `room` [s].
std::size_t cut(const Chain& chain, const std::vector<double>& costs, double room) {
  std::size_t head = chain.size();
  while (head > 0 && 0.5 * costs[index_of(chain[head - 1])] <= room) {
    room -= costs[index_of(chain[--head])];
  }
  return head;
}

void assign(const ChainGroup& group, const std::vector<double>& costs, ProcessorLists& lists) {
  double total = 0.0;
  double longest = 0.0;
  for (const Chain& chain : group) {
    const double cost = sum_over(chain, costs);
    total += cost;
    longest = std::max(longest, cost);
  }
  const double share = std::max(total / static_cast<double>(lists.size()), longest);
  std::size_t p = 0;
  double room = share;
  for (const Chain& chain : group) {
    const bool last = p + 1 == lists.size();
    const std::size_t head = last ? 0 : cut(chain, costs, room);
    const auto middle = chain.begin() + static_cast<std::ptrdiff_t>(head);
    lists[p].insert(lists[p].end(), middle, chain.end());
    for (auto c = middle; c != chain.end(); ++c) room -= costs[index_of(*c)];
    if (head == 0) continue;
    ++p;
    room = share;
    lists[p].insert(lists[p].end(), chain.begin(), middle);
    for (auto c = chain.begin(); c != middle; ++c) room -= costs[index_of(*c)];
  }
}

// Reachability where every processor runs its clusters one after the other: of each cluster, per
// processor the last place of what comes before it, itself included (a vector clock).
class VectorClocks {
 public:
  VectorClocks(std::size_t clusters, int processors)
      : width_(index_of(processors)), places_(clusters * width_, -1) {}

  std::span<int> of(int cluster) { return {places_.data() + index_of(cluster) * width_, width_}; }

 private:
  std::size_t width_;
  std::vector<int> places_;
};

// A plan on its way into the order of a schedule.
class Ordering {
 public:
  Ordering(const Plan& plan, const Schedule& schedule)
      : plan_(plan),
        slots_(schedule.slots),
        processors_(schedule.processors),
        order_(slots_.size()),
        number_(slots_.size()),
        place_(slots_.size()),
        clocks_(slots_.size(), schedule.processors) {
    std::iota(order_.begin(), order_.end(), 0);
    // Ascending along all edges: nothing starts before what it waits for has ended, and of two
    // that cost nothing the plan's order holds.
    const auto key = [this](int c) {
      return std::tuple(slots_[index_of(c)].start, slots_[index_of(c)].end, c);
    };
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return key(a) < key(b); });
    for (std::size_t k = 0; k < order_.size(); ++k)
      number_[index_of(order_[k])] = static_cast<int>(k);
  }

  Plan run() {
    std::vector<int> last(index_of(processors_), -1);  // per processor the cluster it ran last
    CompressedRows<NodeId> clusters;
    CompressedRows<int> predecessors;
    for (const int c : order_) {
      int& previous = last[index_of(slots_[index_of(c)].processor)];
      place_[index_of(c)] = previous < 0 ? 0 : place_[index_of(previous)] + 1;
      for (const int before : needed_predecessors(c, previous)) {
        predecessors.push_back(number_[index_of(before)]);
      }
      predecessors.end_row_sorted();
      clusters.append(plan_.nodes(c));
      clusters.end_row();
      previous = c;
    }
    return {std::move(clusters), transpose(predecessors)};
  }

 private:
  // The last of the predecessors on each processor, `previous` on the own one, less what the others
  // imply. Sets the cluster's clock.
  std::vector<int> needed_predecessors(int cluster, int previous) {
    std::vector<int> latest;
    if (previous >= 0) latest.push_back(previous);
    for (const int before : plan_.predecessors(cluster)) {
      const int processor = slots_[index_of(before)].processor;
      const auto same = std::find_if(latest.begin(), latest.end(), [&](int other) {
        return slots_[index_of(other)].processor == processor;
      });
      if (same == latest.end()) {
        latest.push_back(before);
      } else if (place_[index_of(*same)] < place_[index_of(before)]) {
        *same = before;
      }
    }
    const auto clock = clocks_.of(cluster);
    std::vector<int> needed;
    for (const int before : latest) {
      const bool implied = std::any_of(latest.begin(), latest.end(), [&](int other) {
        return other != before && clocks_.of(other)[index_of(slots_[index_of(before)].processor)] >=
                                      place_[index_of(before)];
      });
      if (!implied) needed.push_back(before);
      const auto earlier = clocks_.of(before);
      std::transform(clock.begin(), clock.end(), earlier.begin(), clock.begin(),
                     [](int a, int b) { return std::max(a, b); });
    }
    clock[index_of(slots_[index_of(cluster)].processor)] = place_[index_of(cluster)];
    return needed;
  }

  const Plan& plan_;
  const std::vector<Slot>& slots_;
  int processors_;
  std::vector<int> order_;   // clusters by start
  std::vector<int> number_;  // per cluster its index in order_
  std::vector<int> place_;   // per cluster its place among those of its processor
  VectorClocks clocks_;
};

}  // namespace

ProcessorLists wrap_around_lists(const Plan& plan, std::span<const double> node_costs,
                                 int processors, const Overheads& overheads) {
  std::vector<double> costs = cluster_costs(plan, node_costs);
  for (double& cost : costs) cost += overheads.per_cluster;
  ProcessorLists lists(index_of(processors));
  for (const ChainGroup& group : find_groups(plan)) assign(group, costs, lists);
  return lists;
}

Plan order_by_schedule(const Plan& plan, std::span<const double> node_costs,
                       const Schedule& schedule) {
  return merge_chains(Ordering(plan, schedule).run(), node_costs,
                      std::numeric_limits<double>::infinity());
}

}  // namespace spoke::graph
