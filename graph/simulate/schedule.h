#pragma once

// Schedules of a plan, the times of its clusters, and bounds.

#include <span>
#include <vector>

#include "graph/plan/plan.h"

namespace spoke::graph {

/// The costs of running a plan beside its nodes' bodies [s]; the defaults are those of oneTBB on
/// common processors, which is enough for plans that are tried on real runs.
struct Overheads {
  double per_node = 2e-9;      ///< calling a node within its cluster
  double per_cluster = 80e-9;  ///< starting a cluster
  double handover = 0.8e-6;    ///< a cluster starts on another processor than made it ready
};

/// The place and time of a cluster in a schedule [s from the start of the run]; its overheads are
/// part of it, a handover delays the start.
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

/// Returns for each cluster its time with nodes and overheads, without handovers [s].
std::vector<double> cluster_times(const Plan& plan, std::span<const double> node_costs,
                                  const Overheads& overheads);

/// Returns the work T1: the sum of all nodes' costs [s].
double work_of(std::span<const double> node_costs);
/// Returns the span Tinf: the costliest path of clusters [s], without overheads.
double span_of(const Plan& plan, std::span<const double> node_costs);

}  // namespace spoke::graph
