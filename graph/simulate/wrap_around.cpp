// Finds chains and their groups, cuts them into shares, and adds the edges that hold lists.

#include "graph/simulate/wrap_around.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "graph/plan/coarsening.h"
#include "graph/structure/index_of.h"
#include "graph/structure/transitive_reduction.h"

namespace spoke::graph {
namespace {

// Chain of clusters, each the only successor of the one before.
using Chain = std::vector<int>;
using ChainGroup = std::vector<Chain>;  // chains between the same predecessors and successors

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

// Finds the groups in the order of their first clusters, which is a topological order of the
// groups.
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

// Returns how many of the chain's first clusters are left to the next processor, so that the rest
// best fits into `room` [s].
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

// Returns all clusters in an order that ascends along the plan's edges and along each list.
std::vector<int> merge_lists(const Plan& plan, const ProcessorLists& lists) {
  std::vector<std::size_t> waiting_for(index_of(plan.cluster_count()));
  for (int c = 0; c < plan.cluster_count(); ++c)
    waiting_for[index_of(c)] = plan.predecessors(c).size();
  std::vector<std::size_t> done(lists.size(), 0);
  std::vector<int> merged;
  while (merged.size() < waiting_for.size()) {
    [[maybe_unused]] const std::size_t before = merged.size();
    for (std::size_t p = 0; p < lists.size(); ++p) {
      while (done[p] < lists[p].size() && waiting_for[index_of(lists[p][done[p]])] == 0) {
        merged.push_back(lists[p][done[p]++]);
        for (const int next : plan.successors(merged.back())) --waiting_for[index_of(next)];
      }
    }
    assert(merged.size() > before);  // otherwise the lists and edges make a cycle
  }
  return merged;
}

}  // namespace

ProcessorLists wrap_around_lists(const Plan& plan, std::span<const double> node_costs,
                                 int processors, const Overheads& overheads) {
  std::vector<double> costs = cluster_costs(plan, node_costs);
  for (double& cost : costs) cost += overheads.per_cluster;
  ProcessorLists lists(index_of(processors));
  for (const ChainGroup& group : find_groups(plan)) assign(group, costs, lists);
  return lists;
}

Plan order_by_lists(const Plan& plan, std::span<const double> node_costs,
                    const ProcessorLists& lists) {
  const std::vector<int> order = merge_lists(plan, lists);
  std::vector<int> number(order.size());  // per cluster its index in `order`
  for (std::size_t k = 0; k < order.size(); ++k) number[index_of(order[k])] = static_cast<int>(k);
  std::vector<std::vector<int>> predecessors(order.size());
  const auto add_edge = [&](int from, int to) {
    predecessors[index_of(number[index_of(to)])].push_back(number[index_of(from)]);
  };
  for (const int c : order) {
    for (const int before : plan.predecessors(c)) add_edge(before, c);
  }
  for (const std::vector<int>& list : lists) {
    for (std::size_t k = 1; k < list.size(); ++k) add_edge(list[k - 1], list[k]);
  }
  for (std::vector<int>& before : predecessors) std::sort(before.begin(), before.end());
  reduce_transitively(predecessors);

  CompressedRows<NodeId> clusters;
  CompressedRows<int> rows;
  for (std::size_t k = 0; k < order.size(); ++k) {
    clusters.append(plan.nodes(order[k]));
    clusters.end_row();
    rows.append(predecessors[k]);
    rows.end_row();
  }
  return merge_chains({std::move(clusters), transpose(rows)}, node_costs,
                      std::numeric_limits<double>::infinity());
}

}  // namespace spoke::graph
