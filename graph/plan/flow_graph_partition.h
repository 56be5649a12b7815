#pragma once

// Shares out clusters among several oneTBB flow graphs.

#include <vector>

#include "graph/plan/plan.h"

namespace spoke::graph {

/// Returns for each cluster of `plan` which of several oneTBB flow graphs it belongs to when
/// `threads` threads run it, from 0 on without gaps. A flow graph has one counter of its tasks, and
/// threads that start small clusters at the same time wait for it most of the time. So the clusters
/// are shared out among several graphs. Neighbours in depth-first order share one: they belong to a
/// few chains, which the same thread mostly runs.
std::vector<int> partition_clusters(const Plan& plan, int threads);

}  // namespace spoke::graph
