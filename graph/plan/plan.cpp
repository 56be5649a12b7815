// Makes plans of single nodes and of one cluster, and proves that a plan is right.

#include "graph/plan/plan.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "graph/structure/index_of.h"
#include "graph/structure/reachability.h"

namespace spoke::graph {
namespace {

// The place where a plan runs a node.
struct Place {
  int cluster = -1;
  int position = -1;  // place within the cluster
};

Reachability descendants_of(const Plan& plan) {
  Reachability descendants(plan.cluster_count());
  for (int c = plan.cluster_count(); c-- > 0;) {
    for (const int next : plan.successors(c)) descendants.absorb(c, next);
  }
  return descendants;
}

std::string check_clusters(const Plan& plan, std::vector<Place>& places) {
  for (int c = 0; c < plan.cluster_count(); ++c) {
    for (const int next : plan.successors(c)) {
      if (next <= c) return "edge from cluster " + std::to_string(c) + " leads back";
    }
    int position = 0;
    for (const NodeId node : plan.nodes(c)) {
      if (places[index_of(node)].cluster >= 0)
        return "node " + std::to_string(node.index) + " twice";
      places[index_of(node)] = {c, position++};
    }
  }
  return {};
}

}  // namespace

CompressedRows<int> transpose(const CompressedRows<int>& rows) {
  const std::size_t count = rows.row_count();
  std::vector<std::size_t> next(count + 1, 0);  // where the next entry of a column goes
  for (std::size_t i = 0; i < count; ++i) {
    for (const int j : rows.row(i)) ++next[static_cast<std::size_t>(j) + 1];
  }
  for (std::size_t j = 0; j < count; ++j) next[j + 1] += next[j];
  std::vector<std::size_t> begins = next;
  std::vector<int> values(rows.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (const int j : rows.row(i))
      values[next[static_cast<std::size_t>(j)]++] = static_cast<int>(i);
  }
  return {std::move(begins), std::move(values)};
}

Plan::Plan(CompressedRows<NodeId> clusters, CompressedRows<int> successors)
    : clusters_(std::move(clusters)),
      successors_(std::move(successors)),
      predecessors_(transpose(successors_)) {}

Plan plan_of_single_nodes(const StepGraph& graph) {
  const auto order = graph.serial_order();
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[index_of(order[k])] = static_cast<int>(k);
  CompressedRows<NodeId> clusters;
  CompressedRows<int> successors;
  clusters.reserve(order.size(), order.size());
  successors.reserve(order.size(), static_cast<std::size_t>(graph.edge_count()));
  for (const NodeId node : order) {
    clusters.push_back(node);
    clusters.end_row();
    for (const NodeId next : graph.successors(node)) successors.push_back(place[index_of(next)]);
    successors.end_row_sorted();
  }
  return {std::move(clusters), std::move(successors)};
}

Plan serial_plan(const StepGraph& graph) {
  if (graph.node_count() == 0) return {};
  CompressedRows<NodeId> clusters;
  CompressedRows<int> successors;
  clusters.append(graph.serial_order());
  clusters.end_row();
  successors.end_row();
  return {std::move(clusters), std::move(successors)};
}

std::vector<double> cluster_costs(const Plan& plan, std::span<const double> node_costs) {
  assert(std::cmp_equal(node_costs.size(), plan.node_count()));
  std::vector<double> costs(static_cast<std::size_t>(plan.cluster_count()), 0.0);
  for (int c = 0; c < plan.cluster_count(); ++c) {
    for (const NodeId node : plan.nodes(c))
      costs[static_cast<std::size_t>(c)] += node_costs[index_of(node)];
  }
  return costs;
}

int level_width(const Plan& plan) {
  std::vector<std::size_t> depth(static_cast<std::size_t>(plan.cluster_count()), 0);
  std::vector<int> width;
  for (int c = 0; c < plan.cluster_count(); ++c) {
    std::size_t level = 0;
    for (const int before : plan.predecessors(c)) {
      level = std::max(level, depth[static_cast<std::size_t>(before)] + 1);
    }
    depth[static_cast<std::size_t>(c)] = level;
    width.resize(std::max(width.size(), level + 1), 0);
    ++width[level];
  }
  return width.empty() ? 0 : *std::max_element(width.begin(), width.end());
}

std::string find_fault(const Plan& plan, const StepGraph& graph) {
  if (plan.node_count() != graph.node_count()) return "number of nodes";
  std::vector<Place> places(static_cast<std::size_t>(graph.node_count()));
  std::string fault = check_clusters(plan, places);
  if (!fault.empty()) return fault;
  const Reachability descendants = descendants_of(plan);
  for (int i = 0; i < graph.node_count(); ++i) {
    const Place from = places[static_cast<std::size_t>(i)];
    for (const NodeId next : graph.successors({i})) {
      const Place to = places[index_of(next)];
      const bool honoured = from.cluster == to.cluster
                                ? from.position < to.position
                                : descendants.contains(from.cluster, to.cluster);
      if (!honoured) {
        return "edge from node " + std::to_string(i) + " to " + std::to_string(next.index);
      }
    }
  }
  return {};
}

}  // namespace spoke::graph
