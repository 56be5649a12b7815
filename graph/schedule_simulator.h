#pragma once

#include <span>
#include <vector>

#include "graph/plan.h"

namespace spoke::graph {

/// What running a plan costs beside its nodes' bodies [s].
struct Overheads {
  double per_node = 2e-9;    ///< calling a node within its cluster
  double per_cluster = 0.0;  ///< starting a cluster with which its processor goes on
  double handover = 0.0;     ///< a cluster starts on another processor than made it ready
  /// Under work stealing, what another processor writes too takes this long to come: the place at
  /// which neighbours are counted when they start (counting_places()), for a start after one on
  /// another processor; and, as long as another processor has nothing to do and searches, the list
  /// of what is kept.
  double contention = 0.0;
  /// And from the moment a place of counting goes to a processor, others wait this long to get it.
  double counting = 0.0;
  /// Under work stealing, what a cluster takes longer that its processor has kept meanwhile.
  double keeping = 0.0;
  /// What each cluster takes longer in a graph of kManyClusters, and in proportion in smaller ones
  /// (crowding()): what the runtime keeps of them does not stay in the nearer caches.
  double among_many = 0.0;
};

inline constexpr int kManyClusters = 12'000;
/// How much of Overheads::among_many each of so many clusters takes, from 0 to 1.
double crowding(int clusters);

/// Where and when a cluster runs [s from the start of the run]; its overheads are part of it, a
/// handover delays the start.
struct Slot {
  int processor = -1;
  double start = 0.0;
  double end = 0.0;
};

struct Schedule {
  int processors = 0;
  double makespan = 0.0;    ///< [s]
  std::vector<Slot> slots;  ///< per cluster
};

/// Per processor the clusters it runs, in that order.
using ProcessorLists = std::vector<std::vector<int>>;

/// Per cluster what it takes with its nodes and overheads, without handovers [s].
std::vector<double> cluster_times(const Plan& plan, std::span<const double> node_costs,
                                  const Overheads& overheads);

/// The work T1: the sum of all nodes' costs [s].
double work_of(std::span<const double> node_costs);
/// The span Tinf: the costliest path of clusters [s], without overheads.
double span_of(const Plan& plan, std::span<const double> node_costs);

/// Per cluster its bottom level: the costliest path that begins with it [s], without overheads.
std::vector<double> bottom_levels(const Plan& plan, std::span<const double> costs_of_clusters);

/// List scheduling by bottom level: whenever a processor is idle and a cluster ready, the ready
/// cluster of the largest bottom level starts, on the processor that made it ready if that one is
/// idle. Clusters without predecessors are made ready by processor 0. Event-driven; near-linear.
Schedule simulate_list_schedule(const Plan& plan, std::span<const double> node_costs,
                                int processors, const Overheads& overheads);

/// Each processor runs its list in order, waiting for predecessors. The lists hold every cluster
/// once, in an order that, together with the plan's edges, makes no cycle.
Schedule simulate_lists(const Plan& plan, std::span<const double> node_costs,
                        const ProcessorLists& lists, const Overheads& overheads);

}  // namespace spoke::graph
