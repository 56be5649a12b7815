#include "graph/plan_candidates.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "graph/coarsening.h"
#include "graph/cost_variation.h"
#include "graph/flow_graph_runs.h"
#include "graph/schedule_order.h"
#include "graph/work_stealing.h"

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

// Of all that are added, by ordering.
class ByOrdering {
 public:
  void add(Candidate candidate) {
    const auto ordering = static_cast<std::size_t>(candidate.ordering);
    candidates_[ordering].push_back(std::move(candidate));
  }

  std::vector<Candidate> best(std::size_t per_ordering) && {
    std::vector<Candidate> best;
    for (std::vector<Candidate>& candidates : candidates_) {
      std::stable_sort(
          candidates.begin(), candidates.end(),
          [](const Candidate& a, const Candidate& b) { return a.makespan < b.makespan; });
      take_different(candidates, per_ordering, best);
    }
    return best;
  }

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

  std::array<std::vector<Candidate>, kOrderings> candidates_;
};

// Makes plans and scores them.
class Selection {
 public:
  Selection(std::span<const double> costs, int processors, const Overheads& overheads)
      : costs_(costs), processors_(processors), overheads_(overheads) {}

  // Scores a coarsened plan in all orderings, unless one like it was seen.
  void add(Plan plan) {
    const double span = span_of(plan, costs_);
    if (!seen_.insert({plan.cluster_count(), plan.edge_count(), span}).second) return;
    score_by_lists(plan);
    const ProcessorLists lists = wrap_around_lists(plan, costs_, processors_, overheads_);
    const Schedule wrapped = simulate_lists(plan, costs_, lists, overheads_);
    score(order_by_schedule(plan, costs_, wrapped), Ordering::wrap_around);
    score(std::move(plan), Ordering::none);
  }

  std::vector<Candidate> best(std::size_t per_ordering) && {
    return std::move(candidates_).best(per_ordering);
  }
  int tried() const { return tried_; }

 private:
  // A list schedule looks no further than to what is ready, and what comes of that is chance: small
  // plans are tried several times, with costs that are a bit off.
  void score_by_lists(const Plan& plan) {
    constexpr double off = 0.2;
    const int tries = std::clamp(1000 / std::max(plan.node_count(), 1), 1, 16);
    CostVariation vary(costs_, off);
    for (int k = 0; k < tries; ++k) {
      const Schedule list = simulate_list_schedule(
          plan, k == 0 ? costs_ : std::span<const double>(vary()), processors_, overheads_);
      score(order_by_schedule(plan, costs_, list), Ordering::by_list);
    }
  }

  void score(Plan plan, Ordering ordering) {
    if (level_width(plan) <= 1) return;
    ++tried_;
    const double makespan = simulate_work_stealing(plan, costs_, processors_, overheads_).makespan;
    candidates_.add({std::move(plan), ordering, makespan});
  }

  std::span<const double> costs_;
  int processors_;
  Overheads overheads_;
  int tried_ = 0;
  std::set<std::tuple<int, int, double>> seen_;
  ByOrdering candidates_;
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

std::size_t weighable_candidates(const StepGraph& graph) {
  constexpr std::size_t nodes = 60'000, fewest = 4, most = 16;
  const auto count = static_cast<std::size_t>(std::max(graph.node_count(), 1));
  return std::clamp(
      nodes / (count * static_cast<std::size_t>(1 + simulated_flow_graph_runs(graph.node_count()))),
      fewest, most);
}

std::vector<Candidate> weigh_candidates(std::vector<Candidate> candidates, const StepGraph& graph,
                                        std::span<const double> node_costs, int processors,
                                        const RuntimeCosts& runtime, std::size_t per_ordering) {
  ByOrdering weighed;
  for (Candidate& candidate : candidates) {
    candidate.makespan =
        simulate_flow_graph_runs(graph, candidate.plan, node_costs, processors, runtime);
    weighed.add(std::move(candidate));
  }
  return std::move(weighed).best(per_ordering);
}

}  // namespace spoke::graph
