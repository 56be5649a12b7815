#pragma once

// Orders of clusters by a schedule, such as the wrap-around assignment.

#include <span>

#include "graph/plan/plan.h"
#include "graph/simulate/schedule_simulator.h"

namespace spoke::graph {

/// A wrap-around assignment (McNaughton's rule). Chains of clusters between the same predecessors
/// and successors are laid out end to end and cut, between clusters, into one equal share per
/// processor. Of the chain that is cut, the later clusters end one processor's share and the
/// earlier ones begin the next processor's, so that at most processors - 1 chains of a group change
/// hands. Groups follow each other in topological order.
ProcessorLists wrap_around_lists(const Plan& plan, std::span<const double> node_costs,
                                 int processors, const Overheads& overheads);

/// `plan` with edges added such that clusters which share a processor in `schedule` keep its order,
/// less the edges that others then imply, and with what has become a chain merged. At no time are
/// more clusters ready or running than processors, so that any scheduler follows the schedule.
Plan order_by_schedule(const Plan& plan, std::span<const double> node_costs,
                       const Schedule& schedule);

}  // namespace spoke::graph
