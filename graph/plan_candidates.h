#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "graph/plan.h"
#include "graph/runtime_costs.h"
#include "graph/schedule_simulator.h"

namespace spoke::graph {

/// How the clusters of a plan are ordered beyond the edges of the graph.
enum class Ordering {
  none,         ///< whoever is free takes what is ready
  by_list,      ///< by a list schedule
  wrap_around,  ///< by wrap_around_lists()
};
inline constexpr int kOrderings = 3;

struct Candidate {
  Plan plan;
  Ordering ordering = Ordering::none;
  double makespan = 0.0;  ///< [s], simulated, with overheads
};

/// Plans worth trying on `processors`, the best of each ordering first: at most `per_ordering` of
/// each, from a grid of coarsening options, scored by the schedule simulator. Plans that one thread
/// would run, of one cluster or a chain of clusters, are not among them. `tried`, if given,
/// receives the number of plans that were scored.
std::vector<Candidate> find_candidates(const StepGraph& graph, std::span<const double> node_costs,
                                       int processors, const Overheads& overheads,
                                       std::size_t per_ordering, int* tried = nullptr);

/// How many candidates of each ordering can be weighed more closely, by simulate_flow_graph_runs(),
/// in some tens of milliseconds.
std::size_t weighable_candidates(const StepGraph& graph);

/// Of candidates those that are best, at most `per_ordering` of each, when they are weighed with
/// what all clusters that start and all data that move cost.
std::vector<Candidate> weigh_candidates(std::vector<Candidate> candidates, const StepGraph& graph,
                                        std::span<const double> node_costs, int processors,
                                        const RuntimeCosts& runtime, std::size_t per_ordering);

}  // namespace spoke::graph
