#include "graph/plan_candidates.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "graph/coarsening.h"
#include "graph/schedule_order.h"

namespace spoke::graph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Grains from about what a cluster costs to start up to a share that leaves nothing to choose.
std::vector<CoarseningOptions> option_grid(double work, int processors,
                                           const Overheads& overheads) {
  const double unit = overheads.per_cluster + overheads.handover;
  const double share = work / processors;
  std::vector<CoarseningOptions> grid{{}};  // chains only, for nodes or processors in plenty
  for (const double factor : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0}) {
    const double grain = factor * unit;
    if (grain > share && factor > 1.0) break;
    for (const int bins : {1, 2, 4}) {
      for (const double pieces : {0.0, 4.0, 16.0, 64.0}) {
        const double longest = pieces > 0.0 ? share / pieces : kInfinity;
        if (longest > grain) grid.push_back({grain, bins * processors, longest});
      }
    }
  }
  return grid;
}

// Keeps the best candidates of each ordering.
class Selection {
 public:
  Selection(std::span<const double> costs, int processors, const Overheads& overheads)
      : costs_(costs), processors_(processors), overheads_(overheads) {}

  // Scores a coarsened plan in all orderings, unless one like it was seen.
  void add(Plan plan) {
    const double span = span_of(plan, costs_);
    if (!seen_.insert({plan.cluster_count(), plan.edge_count(), span}).second) return;
    const Schedule list = simulate_list_schedule(plan, costs_, processors_, overheads_);
    const ProcessorLists lists = wrap_around_lists(plan, costs_, processors_, overheads_);
    const Schedule wrapped = simulate_lists(plan, costs_, lists, overheads_);
    score(order_by_schedule(plan, costs_, list), Ordering::by_list);
    score(order_by_schedule(plan, costs_, wrapped), Ordering::wrap_around);
    score(std::move(plan), Ordering::none);
  }

  std::vector<Candidate> best(std::size_t per_ordering) && {
    std::vector<Candidate> best;
    for (std::vector<Candidate>& candidates : by_ordering_) {
      std::stable_sort(
          candidates.begin(), candidates.end(),
          [](const Candidate& a, const Candidate& b) { return a.makespan < b.makespan; });
      take_different(candidates, per_ordering, best);
    }
    return best;
  }
  int tried() const { return tried_; }

 private:
  // Plans of equal numbers of clusters and edges are as good as equal.
  static void take_different(std::vector<Candidate>& sorted, std::size_t most,
                             std::vector<Candidate>& taken) {
    std::set<std::pair<int, int>> sizes;
    for (Candidate& candidate : sorted) {
      if (sizes.size() == most) break;
      const Plan& plan = candidate.plan;
      if (!sizes.insert({plan.cluster_count(), plan.edge_count()}).second) continue;
      taken.push_back(std::move(candidate));
    }
  }

  void score(Plan plan, Ordering ordering) {
    if (level_width(plan) <= 1) return;
    ++tried_;
    const double makespan = simulate_work_stealing(plan, costs_, processors_, overheads_).makespan;
    by_ordering_[static_cast<std::size_t>(ordering)].push_back(
        {std::move(plan), ordering, makespan});
  }

  std::span<const double> costs_;
  int processors_;
  Overheads overheads_;
  int tried_ = 0;
  std::set<std::tuple<int, int, double>> seen_;
  std::array<std::vector<Candidate>, kOrderings> by_ordering_;
};

}  // namespace

std::vector<Candidate> find_candidates(const StepGraph& graph, std::span<const double> node_costs,
                                       int processors, const Overheads& overheads,
                                       std::size_t per_ordering, int* tried) {
  Selection selection(node_costs, processors, overheads);
  const Plan single = plan_of_single_nodes(graph);
  for (const CoarseningOptions& options : option_grid(work_of(node_costs), processors, overheads)) {
    selection.add(coarsen(single, node_costs, options));
  }
  if (tried) *tried = selection.tried();
  return std::move(selection).best(per_ordering);
}

}  // namespace spoke::graph
