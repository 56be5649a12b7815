// Work, span, and schedules whose lists are given.

#include "graph/simulate/schedule_simulator.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

std::vector<int> count_predecessors(const Plan& plan) {
  std::vector<int> counts(index_of(plan.cluster_count()));
  for (int c = 0; c < plan.cluster_count(); ++c) {
    counts[index_of(c)] = static_cast<int>(plan.predecessors(c).size());
  }
  return counts;
}

// The state of a schedule whose lists are given.
class ListRunner {
 public:
  ListRunner(const Plan& plan, std::span<const double> node_costs, const ProcessorLists& lists,
             const Overheads& overheads)
      : plan_(plan),
        lists_(lists),
        handover_(overheads.handover),
        durations_(cluster_times(plan, node_costs, overheads)),
        waiting_for_(count_predecessors(plan)),
        done_(lists.size(), 0),
        free_at_(lists.size(), 0.0),
        schedule_{static_cast<int>(lists.size()), 0.0, std::vector<Slot>(durations_.size())} {}

  Schedule run() && {
    for (std::size_t p = 0; p < lists_.size(); ++p) {
      for (const int cluster : lists_[p]) {
        schedule_.slots[index_of(cluster)].processor = static_cast<int>(p);
      }
      to_visit_.push_back(static_cast<int>(p));
    }
    while (!to_visit_.empty()) {
      const int processor = to_visit_.back();
      to_visit_.pop_back();
      advance(processor);
    }
    return std::move(schedule_);
  }

 private:
  // Runs a processor's list as far as predecessors allow.
  void advance(int processor) {
    const std::vector<int>& list = lists_[index_of(processor)];
    std::size_t& next = done_[index_of(processor)];
    while (next < list.size() && waiting_for_[index_of(list[next])] == 0) run(list[next++]);
  }

  void run(int cluster) {
    Slot& slot = schedule_.slots[index_of(cluster)];
    double& free_at = free_at_[index_of(slot.processor)];
    const bool from_caller = plan_.predecessors(cluster).empty() && slot.processor != 0;
    slot.start = std::max(free_at, from_caller ? handover_ : 0.0);
    for (const int before : plan_.predecessors(cluster)) {
      const Slot& other = schedule_.slots[index_of(before)];
      const double delay = other.processor == slot.processor ? 0.0 : handover_;
      slot.start = std::max(slot.start, other.end + delay);
    }
    slot.end = free_at = slot.start + durations_[index_of(cluster)];
    schedule_.makespan = std::max(schedule_.makespan, slot.end);
    for (const int next : plan_.successors(cluster)) {
      const int processor = schedule_.slots[index_of(next)].processor;
      if (--waiting_for_[index_of(next)] == 0 && processor != slot.processor) {
        to_visit_.push_back(processor);
      }
    }
  }

  const Plan& plan_;
  const ProcessorLists& lists_;
  double handover_;
  std::vector<double> durations_;
  std::vector<int> waiting_for_;
  std::vector<std::size_t> done_;  // per processor
  std::vector<double> free_at_;    // per processor [s]
  std::vector<int> to_visit_;      // processors whose next cluster may have become ready
  Schedule schedule_;
};

}  // namespace

std::vector<double> cluster_times(const Plan& plan, std::span<const double> node_costs,
                                  const Overheads& overheads) {
  std::vector<double> times = cluster_costs(plan, node_costs);
  for (int c = 0; c < plan.cluster_count(); ++c) {
    times[index_of(c)] +=
        overheads.per_cluster + overheads.per_node * static_cast<double>(plan.nodes(c).size());
  }
  return times;
}

double work_of(std::span<const double> node_costs) {
  return std::accumulate(node_costs.begin(), node_costs.end(), 0.0);
}

double span_of(const Plan& plan, std::span<const double> node_costs) {
  // Per cluster the costliest path that begins with it.
  std::vector<double> levels = cluster_costs(plan, node_costs);
  for (int c = plan.cluster_count(); c-- > 0;) {
    double longest = 0.0;
    for (const int next : plan.successors(c)) longest = std::max(longest, levels[index_of(next)]);
    levels[index_of(c)] += longest;
  }
  return levels.empty() ? 0.0 : *std::max_element(levels.begin(), levels.end());
}

Schedule simulate_lists(const Plan& plan, std::span<const double> node_costs,
                        const ProcessorLists& lists, const Overheads& overheads) {
  return ListRunner(plan, node_costs, lists, overheads).run();
}

}  // namespace spoke::graph
