#pragma once

// Coarsening: from single nodes to clusters that are worth a handover.

#include <limits>
#include <span>

#include "graph/plan/plan.h"

namespace spoke::graph {

struct CoarseningOptions {
  double grain = 0.0;  ///< [s] siblings are packed into clusters of about that cost, or more
  int max_bins = std::numeric_limits<int>::max();  ///< at most that many clusters of siblings
  /// [s] no cluster of several nodes costs more: what would be a long chain is cut into pieces
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

/// The same, of a plan's clusters; its edges stay honoured, those that only order clusters, too.
Plan coarsen(const Plan& plan, std::span<const double> costs, const CoarseningOptions& options);

/// Merges chains only.
Plan merge_chains(const Plan& plan, std::span<const double> costs, double longest);

}  // namespace spoke::graph
