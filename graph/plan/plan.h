#pragma once

// A plan: the clusters of nodes that run together, and their order.

#include <span>
#include <string>
#include <vector>

#include "graph/compressed_rows.h"
#include "graph/step_graph.h"

namespace spoke::graph {

/// A cluster graph over a step graph: each cluster is a list of nodes that one thread runs in that
/// order, without interruption. A cluster starts when its predecessors have ended. Immutable.
class Plan {
 public:
  /// Makes the plan of an empty graph.
  Plan() = default;
  /// Takes clusters in a topological order: every edge leads from a lower to a higher index.
  /// `successors` has a row per cluster, ascending and without repetitions.
  Plan(CompressedRows<NodeId> clusters, CompressedRows<int> successors);

  int cluster_count() const { return static_cast<int>(clusters_.row_count()); }
  int node_count() const { return static_cast<int>(clusters_.size()); }
  int edge_count() const { return static_cast<int>(successors_.size()); }

  std::span<const NodeId> nodes(int cluster) const {
    return clusters_.row(static_cast<std::size_t>(cluster));
  }
  std::span<const int> successors(int cluster) const {
    return successors_.row(static_cast<std::size_t>(cluster));
  }
  std::span<const int> predecessors(int cluster) const {
    return predecessors_.row(static_cast<std::size_t>(cluster));
  }

 private:
  CompressedRows<NodeId> clusters_;
  CompressedRows<int> successors_;
  CompressedRows<int> predecessors_;
};

/// Returns one cluster per node, in serial order: the step graph as it is.
Plan plan_of_single_nodes(const StepGraph& graph);

/// Returns all nodes in one cluster, in serial order.
Plan serial_plan(const StepGraph& graph);

/// Returns the sums of the nodes' costs per cluster [s].
std::vector<double> cluster_costs(const Plan& plan, std::span<const double> node_costs);

/// Returns the largest number of clusters that lie equally deep, in clusters from the start: about
/// as many as can run at once. 1 if the plan is a chain.
int level_width(const Plan& plan);

/// Returns what is wrong with a plan of `graph`, in words; empty if nothing is. Faults are: a node
/// missing or twice, an edge of the graph that neither a cluster's order nor a path of clusters
/// honours, an edge that leads back. Quadratic in the number of clusters.
std::string find_fault(const Plan& plan, const StepGraph& graph);

}  // namespace spoke::graph
