#pragma once

// What a schedule of a plan is, what its clusters take, and its bounds.

#include <span>
#include <vector>

#include "graph/plan/plan.h"

namespace spoke::graph {

/// What running a plan costs beside its nodes' bodies [s]: by default what oneTBB takes on common
/// processors. Plans that are tried on real runs need no more; predictions measure what a cluster
/// and a handover take (calibrate/runtime_costs.h).
struct Overheads {
  double per_node = 2e-9;      ///< calling a node within its cluster
  double per_cluster = 80e-9;  ///< starting a cluster
  double handover = 0.8e-6;    ///< a cluster starts on another processor than made it ready
};

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

/// Per cluster what it takes with its nodes and overheads, without handovers [s].
std::vector<double> cluster_times(const Plan& plan, std::span<const double> node_costs,
                                  const Overheads& overheads);

/// The work T1: the sum of all nodes' costs [s].
double work_of(std::span<const double> node_costs);
/// The span Tinf: the costliest path of clusters [s], without overheads.
double span_of(const Plan& plan, std::span<const double> node_costs);

}  // namespace spoke::graph
