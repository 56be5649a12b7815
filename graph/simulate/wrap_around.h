#pragma once

// The wrap-around assignment of clusters to processors, and plans that hold an assignment.

#include <span>
#include <vector>

#include "graph/plan/plan.h"
#include "graph/simulate/schedule.h"

namespace spoke::graph {

/// The clusters that each processor runs, in that order.
using ProcessorLists = std::vector<std::vector<int>>;

/// Makes a wrap-around assignment (McNaughton's rule). Chains of clusters between the same
/// predecessors and successors are laid out end to end and cut, between clusters, into one equal
/// share per processor. Of the chain that is cut, the later clusters end one processor's share and
/// the earlier ones begin the next processor's, so that at most processors - 1 chains of a group
/// change hands. Groups follow each other in topological order.
ProcessorLists wrap_around_lists(const Plan& plan, std::span<const double> node_costs,
                                 int processors, const Overheads& overheads);

/// Returns `plan` with edges added such that the clusters of each list keep its order, without the
/// edges that others then imply, and with new chains merged. At no time are more clusters ready or
/// running than lists, so that any scheduler follows them. The lists hold every cluster once, in an
/// order that, together with the plan's edges, makes no cycle.
Plan order_by_lists(const Plan& plan, std::span<const double> node_costs,
                    const ProcessorLists& lists);

}  // namespace spoke::graph
