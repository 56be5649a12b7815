#pragma once

// What several processes would make of a step, whose subsystems they share out.

#include <functional>
#include <span>
#include <vector>

#include "engine/simulation/node_measurement.h"
#include "graph/step_graph.h"

namespace spoke::predict {

/// What lies between processes.
struct Network {
  double latency = 5e-6;     ///< of a message [s]
  bool is_measured = false;  ///< between the processes of this job; else given or assumed
};

/// What a step takes, by who runs it [s].
struct StepShares {
  std::vector<double> subsystems;  ///< the nodes of each
  double common = 0.0;             ///< those of the hub and what is between runs, in every process
  double exchanges = 0.0;          ///< number of gatherings among all processes
};

/// Of a graph over all subsystems whose nodes were measured. `window`: steps after which processes
/// meet.
StepShares find_shares(const graph::StepGraph& graph, const NodeMeasurement& nodes, int window);

/// A step by a number of processes of one thread each.
struct RankPoint {
  int ranks = 1;
  double computing = 0.0;  ///< of the process with most to do [s]
  double telling = 0.0;    ///< on the network [s]

  double step() const { return computing + telling; }
};

/// By processes of the machine that the nodes were measured on. `share_out`: how subsystems are
/// shared out over a number of processes, see spoke::share_out(). A gathering takes as many
/// messages one after the other as the number of processes can be halved; how long they are does
/// not count.
std::vector<RankPoint> predict_ranks(const StepShares& shares, const Network& network,
                                     std::span<const int> ranks,
                                     const std::function<std::vector<int>(int)>& share_out);

}  // namespace spoke::predict
