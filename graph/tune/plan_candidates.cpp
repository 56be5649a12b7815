// Coarsens by a grid of options and scores the plans by simulated runs.

#include "graph/tune/plan_candidates.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "graph/plan/coarsening.h"
#include "graph/simulate/work_stealing.h"
#include "graph/simulate/wrap_around.h"

namespace spoke::graph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns options whose grains go from about what a cluster costs to start up to a share that
// leaves nothing to choose.
std::vector<CoarseningOptions> option_grid(double work, int processors,
                                           const Overheads& overheads) {
  const double unit = overheads.per_cluster + overheads.handover;
  const double share = work / processors;
  // Chains only, where there are plenty of nodes or processors.
  std::vector<CoarseningOptions> grid{{}};
  // Layers packed into long chains of short pieces, for wrap-around, whatever a handover takes.
  grid.push_back({share / 32.0, processors, share / 16.0});
  for (const double factor : {1.0, 4.0, 16.0}) {
    const double grain = factor * unit;
    if (grain > share && factor > 1.0) break;
    for (const int bins : {1, 2}) {
      for (const double pieces : {0.0, 16.0}) {
        const double longest = pieces > 0.0 ? share / pieces : kInfinity;
        if (longest > grain) grid.push_back({grain, bins * processors, longest});
      }
    }
  }
  return grid;
}

// Makes plans and scores them.
class Selection {
 public:
  Selection(std::span<const double> costs, int processors, const Overheads& overheads)
      : costs_(costs), processors_(processors), overheads_(overheads) {}

  // Scores a coarsened plan as it is and in wrap-around order, unless one like it was seen.
  void add(Plan plan) {
    if (!seen_.insert({plan.cluster_count(), plan.edge_count(), span_of(plan, costs_)}).second)
      return;
    score(order_by_lists(plan, costs_, wrap_around_lists(plan, costs_, processors_, overheads_)));
    score(std::move(plan));
  }

  std::vector<Candidate> best(std::size_t most) && {
    std::stable_sort(
        candidates_.begin(), candidates_.end(),
        [](const Candidate& a, const Candidate& b) { return a.makespan < b.makespan; });
    if (candidates_.size() > most)
      candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(most), candidates_.end());
    return std::move(candidates_);
  }

 private:
  void score(Plan plan) {
    if (level_width(plan) <= 1) return;
    const double makespan = simulate_work_stealing(plan, costs_, processors_, overheads_).makespan;
    candidates_.push_back({std::move(plan), makespan});
  }

  std::span<const double> costs_;
  int processors_;
  Overheads overheads_;
  std::set<std::tuple<int, int, double>> seen_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Candidate> find_candidates(const StepGraph& graph, std::span<const double> node_costs,
                                       int processors, const Overheads& overheads,
                                       std::size_t most) {
  assert(static_cast<int>(node_costs.size()) == graph.node_count() && processors >= 1);
  Selection selection(node_costs, processors, overheads);
  const Plan single = plan_of_single_nodes(graph);
  for (const CoarseningOptions& options : option_grid(work_of(node_costs), processors, overheads))
    selection.add(coarsen(single, node_costs, options));
  return std::move(selection).best(most);
}

double least_gain(double seconds_per_run, double handover) {
  return 1.05 + 2.0 * handover / std::max(seconds_per_run, 1e-7);
}

}  // namespace spoke::graph
