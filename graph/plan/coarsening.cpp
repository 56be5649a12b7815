// The rules that merge clusters, and their loop.

#include "graph/plan/coarsening.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

using Groups = std::vector<int>;  // the group that each cluster goes to, -1 = none yet

// A plan while it is coarsened.
struct Coarse {
  Plan plan;
  std::vector<double> costs;  // cost of each cluster [s]
};

// Numbers groups in the order of their first members. That is a topological order of the groups of
// all rules: all siblings share their predecessors, a chain is entered at its first link, and
// nothing follows an end.
int number_by_first_member(Groups& groups) {
  std::vector<int> number(groups.size(), -1);
  int count = 0;
  for (int& group : groups) {
    if (number[index_of(group)] < 0) number[index_of(group)] = count++;
    group = number[index_of(group)];
  }
  return count;
}

CompressedRows<int> members_of(const Groups& groups, int count) {
  std::vector<std::size_t> begins(index_of(count) + 1, 0);
  for (const int group : groups) ++begins[index_of(group) + 1];
  for (std::size_t g = 0; g < index_of(count); ++g) begins[g + 1] += begins[g];
  std::vector<std::size_t> next = begins;
  std::vector<int> members(groups.size());
  for (std::size_t c = 0; c < groups.size(); ++c) {
    members[next[index_of(groups[c])]++] = static_cast<int>(c);
  }
  return {std::move(begins), std::move(members)};
}

// Makes each group one cluster, its members in ascending order, which is topological.
Coarse contract(const Coarse& fine, Groups groups) {
  const int count = number_by_first_member(groups);
  const CompressedRows<int> members = members_of(groups, count);
  CompressedRows<NodeId> clusters;
  CompressedRows<int> successors;
  clusters.reserve(index_of(count), index_of(fine.plan.node_count()));
  successors.reserve(index_of(count), index_of(fine.plan.edge_count()));
  std::vector<double> costs(index_of(count), 0.0);
  for (int g = 0; g < count; ++g) {
    for (const int member : members.row(index_of(g))) {
      clusters.append(fine.plan.nodes(member));
      costs[index_of(g)] += fine.costs[index_of(member)];
      for (const int next : fine.plan.successors(member)) {
        if (groups[index_of(next)] != g) successors.push_back(groups[index_of(next)]);
      }
    }
    clusters.end_row();
    successors.end_row_sorted();
  }
  return {Plan(std::move(clusters), std::move(successors)), std::move(costs)};
}

// Merges chains, whole ones in one sweep along the topological order. Returns whether there were
// any.
bool contract_chains(Coarse& coarse, double longest) {
  const Plan& plan = coarse.plan;
  Groups groups(index_of(plan.cluster_count()));
  std::vector<double> sums = coarse.costs;  // costs of the chains so far, by their first links
  bool any = false;
  for (int c = 0; c < plan.cluster_count(); ++c) {
    groups[index_of(c)] = c;
    const auto before = plan.predecessors(c);
    if (before.size() != 1 || plan.successors(before[0]).size() != 1) continue;
    const int chain = groups[index_of(before[0])];
    if (sums[index_of(chain)] + coarse.costs[index_of(c)] > longest) continue;
    sums[index_of(chain)] += coarse.costs[index_of(c)];
    groups[index_of(c)] = chain;
    any = true;
  }
  if (any) coarse = contract(coarse, std::move(groups));
  return any;
}

// Puts cheap ends, which nothing waits for, into the cluster that they wait for. Returns whether
// there were any. They would hide that chains which differ in their ends alone lead to the same
// place.
bool contract_ends(Coarse& coarse, const CoarseningOptions& options) {
  const Plan& plan = coarse.plan;
  Groups groups(index_of(plan.cluster_count()));
  bool any = false;
  for (int c = 0; c < plan.cluster_count(); ++c) {
    groups[index_of(c)] = c;
    const auto before = plan.predecessors(c);
    if (before.size() != 1 || !plan.successors(c).empty()) continue;
    const double cost = coarse.costs[index_of(c)];
    if (cost >= options.grain || coarse.costs[index_of(before[0])] + cost > options.longest)
      continue;
    groups[index_of(c)] = groups[index_of(before[0])];
    any = true;
  }
  if (any) coarse = contract(coarse, std::move(groups));
  return any;
}

std::uint64_t hash_of(std::span<const int> list, std::uint64_t hash) {
  for (const int value : list) {
    hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

bool are_siblings(const Plan& plan, int a, int b) {
  return std::ranges::equal(plan.predecessors(a), plan.predecessors(b)) &&
         std::ranges::equal(plan.successors(a), plan.successors(b));
}

// Returns clusters with their hashes of predecessors and successors, siblings next to each other.
std::vector<std::pair<std::uint64_t, int>> sorted_by_neighbours(const Plan& plan) {
  std::vector<std::pair<std::uint64_t, int>> keys(index_of(plan.cluster_count()));
  for (int c = 0; c < plan.cluster_count(); ++c) {
    keys[index_of(c)] = {hash_of(plan.successors(c), hash_of(plan.predecessors(c), 1) + 1), c};
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

using Siblings = std::span<const std::pair<std::uint64_t, int>>;

// Puts siblings into bins of equal shares of the cost. Returns whether any bin holds several.
bool pack(const Coarse& coarse, Siblings siblings, const CoarseningOptions& options,
          Groups& groups) {
  double total = 0.0;
  for (const auto& [hash, c] : siblings) total += coarse.costs[index_of(c)];
  const double most = std::min<double>(options.max_bins, static_cast<double>(siblings.size()));
  const double least = std::clamp(std::ceil(total / options.longest), 1.0, most);
  const double wanted = options.grain > 0.0 ? std::floor(total / options.grain)
                        : total > 0.0       ? most
                                            : 1.0;
  const double bins = std::clamp(wanted, least, most);
  if (bins >= static_cast<double>(siblings.size())) return false;
  std::vector<int> first_of_bin(static_cast<std::size_t>(bins), -1);
  double before = 0.0;
  for (const auto& [hash, c] : siblings) {
    const double middle = before + 0.5 * coarse.costs[index_of(c)];
    before += coarse.costs[index_of(c)];
    const double share = total > 0.0 ? middle / total : 0.0;
    const double bin = std::min(std::floor(share * bins), bins - 1.0);
    int& first = first_of_bin[static_cast<std::size_t>(bin)];
    if (first < 0) first = c;
    groups[index_of(c)] = first;
  }
  return true;
}

bool contract_siblings(Coarse& coarse, const CoarseningOptions& options) {
  const auto keys = sorted_by_neighbours(coarse.plan);
  Groups groups(keys.size());
  for (std::size_t c = 0; c < groups.size(); ++c) groups[c] = static_cast<int>(c);
  bool any = false;
  for (std::size_t begin = 0; begin < keys.size();) {
    std::size_t end = begin + 1;
    while (end < keys.size() && keys[end].first == keys[begin].first &&
           are_siblings(coarse.plan, keys[begin].second, keys[end].second)) {
      ++end;
    }
    if (end - begin > 1)
      any |= pack(coarse, Siblings(keys).subspan(begin, end - begin), options, groups);
    begin = end;
  }
  if (any) coarse = contract(coarse, std::move(groups));
  return any;
}

}  // namespace

Plan coarsen(const Plan& plan, std::span<const double> costs, const CoarseningOptions& options) {
  Coarse coarse{plan, cluster_costs(plan, costs)};
  bool changed = true;
  while (changed) {
    // Ends come first: they are cheap to take in while clusters are small.
    changed = contract_ends(coarse, options);
    changed |= contract_chains(coarse, options.longest);
    changed |= contract_siblings(coarse, options);
  }
  return std::move(coarse.plan);
}

Plan coarsen(const StepGraph& graph, std::span<const double> costs,
             const CoarseningOptions& options) {
  return coarsen(plan_of_single_nodes(graph), costs, options);
}

Plan merge_chains(const Plan& plan, std::span<const double> costs, double longest) {
  Coarse coarse{plan, cluster_costs(plan, costs)};
  while (contract_chains(coarse, longest)) {
  }
  return std::move(coarse.plan);
}

}  // namespace spoke::graph
