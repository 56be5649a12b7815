#pragma once

#include <span>
#include <vector>

#include "graph/chance.h"
#include "graph/data_traffic.h"
#include "graph/schedule_simulator.h"

namespace spoke::graph {

/// Work stealing, as oneTBB's flow graphs do it: a cluster tells its successors that it has ended,
/// the last in its list first. Of those that are then ready its processor goes on with the last it
/// has told that is counted at the same place, and keeps the others; it takes what it kept last. So
/// a single processor takes the clusters in depth-first order. A processor that has nothing looks
/// at what one of the others has kept, any of them, at once and again after a period,
/// and takes what that one has kept longest. Clusters without predecessors are kept by processor 0,
/// the last of them first.
///
/// Processors wait for what others have written: the place of counting (Overheads::counting), the
/// list of what is kept, if another has looked at it meanwhile, and with `traffic` the records of
/// clusters and the nodes' data. With `chance`, waits for the place and the list, and handovers,
/// are longer or shorter by up to half of what they are without.
/// `places`: where clusters are counted, unless given counting_places().
/// Event-driven; near-linear.
Schedule simulate_work_stealing(const Plan& plan, std::span<const double> node_costs,
                                int processors, const Overheads& overheads,
                                DataTraffic* traffic = nullptr, Chance* chance = nullptr,
                                std::vector<int> places = {});

}  // namespace spoke::graph
