#pragma once

#include "graph/schedule_simulator.h"

namespace spoke::graph {

/// What the runtimes under the executors cost on a machine, beside the nodes [s].
struct RuntimeCosts {
  Overheads flow_graph;
  /// How much longer a thread of the flow graph takes to start a cluster while another starts one.
  double contention = 0.0;
  double flow_graph_run = 0.0;  ///< starting a run of the flow graph and waiting for its end
  double barrier = 0.0;         ///< an OpenMP barrier of two threads; 0: no OpenMP, not known
  double barrier_alone = 0.0;   ///< of a team of one thread
  Transfer transfer;            ///< of data from another processor's caches
};

/// Starting a cluster of the flow graph where several threads do, if clusters do work of
/// `mean_work` [s] on average: the other thread starts one, too, for as large a share of the time
/// as starting takes of it. More threads than two are not known to change this.
double cluster_among_threads(const RuntimeCosts& costs, double mean_work);

/// Measured once per process on graphs of empty nodes and of busy ones, none of them a model's, in
/// some tens of milliseconds. Bounded to what is plausible, for busy machines.
const RuntimeCosts& runtime_costs();

/// All of them times `factor`.
RuntimeCosts scaled(const RuntimeCosts& costs, double factor);

}  // namespace spoke::graph
