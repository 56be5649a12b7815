#pragma once

// Predicted times of a step whose subsystems several processes share out.

#include <functional>
#include <span>
#include <vector>

#include "engine/simulation/node_measurement.h"
#include "graph/step_graph.h"

namespace spoke::predict {

/// The network between processes.
struct Network {
  double latency = 5e-6;     ///< time of a message [s]
  bool is_measured = false;  ///< measured between the processes of this job; else given or assumed
};

/// Times of a step's parts [s], by the processes that run them.
struct StepShares {
  std::vector<double> subsystems;  ///< time of each subsystem's nodes
  double common = 0.0;             ///< time of the hub's nodes and between runs, in every process
  double exchanges = 0.0;          ///< number of gatherings among all processes
};

/// Returns the shares of a graph over all subsystems whose nodes were measured. `window`: steps
/// after which processes meet.
StepShares find_shares(const graph::StepGraph& graph, const NodeMeasurement& nodes, int window);

/// Times of a step on a number of processes of one thread each.
struct RankPoint {
  int ranks = 1;
  double computing = 0.0;  ///< time of the process with most to do [s]
  double telling = 0.0;    ///< time on the network [s]

  double step() const { return computing + telling; }
};

/// Predicts a step on processes of the machine on which the nodes were measured. `share_out`: how
/// subsystems are shared out over a number of processes, see spoke::share_out(). A gathering takes
/// as many messages one after the other as the number of processes can be halved; the length of
/// messages does not count.
std::vector<RankPoint> predict_ranks(const StepShares& shares, const Network& network,
                                     std::span<const int> ranks,
                                     const std::function<std::vector<int>(int)>& share_out);

}  // namespace spoke::predict
