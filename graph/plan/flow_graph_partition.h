#pragma once

// How clusters are shared out among several oneTBB flow graphs.

#include <vector>

#include "graph/plan/plan.h"

namespace spoke::graph {

/// Per cluster of `plan`, at which of several places its start and end are counted when `threads`
/// threads run the plan as oneTBB flow graphs, from 0 on without gaps. A flow graph counts its
/// tasks in one place in memory, and threads that start small clusters at the same time wait for it
/// most of the time. So the clusters are spread over several flow graphs. Neighbours in depth-first
/// order share a place: they belong to a few chains, which the same thread mostly runs.
std::vector<int> counting_places(const Plan& plan, int threads);

}  // namespace spoke::graph
