#pragma once

// Coarsening: from single nodes to clusters that are worth a handover.

#include <limits>
#include <span>

#include "graph/plan/plan.h"

namespace spoke::graph {

struct CoarseningOptions {
  double grain = 0.0;  ///< cost of a cluster [s] into which siblings are packed, or more
  int max_bins = std::numeric_limits<int>::max();  ///< most clusters of siblings
  /// Most cost of a cluster of several nodes [s]: longer chains are cut into pieces.
  double longest = std::numeric_limits<double>::infinity();
};

/// Coarsens a step graph by its structure and its nodes' costs alone [s, by index]. Three rules
/// take turns until none changes anything:
///  - chains, where one's only successor has no other predecessor, become one cluster;
///  - siblings, which have the same predecessors and the same successors, are packed into
///    clamp(total cost / grain, 1, max_bins) clusters, neighbours in serial order together;
///  - ends, which nothing waits for and which cost less than `grain`, join the only cluster they
///    wait for, unless that makes it too long.
/// A layer that is packed into one cluster is a link of a chain, so layers vanish or stay by their
/// cost. No rule can make a cycle. Near-linear in nodes and edges.
Plan coarsen(const StepGraph& graph, std::span<const double> costs,
             const CoarseningOptions& options);

/// Coarsens a plan's clusters by these rules; its edges stay honoured, also those that only order
/// clusters.
Plan coarsen(const Plan& plan, std::span<const double> costs, const CoarseningOptions& options);

/// Merges only chains.
Plan merge_chains(const Plan& plan, std::span<const double> costs, double longest);

}  // namespace spoke::graph
