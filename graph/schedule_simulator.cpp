#include "graph/schedule_simulator.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace spoke::graph {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::vector<int> count_predecessors(const Plan& plan) {
  std::vector<int> counts(at(plan.cluster_count()));
  for (int c = 0; c < plan.cluster_count(); ++c) {
    counts[at(c)] = static_cast<int>(plan.predecessors(c).size());
  }
  return counts;
}

// The state of an event-driven list schedule.
class ListScheduler {
 public:
  ListScheduler(const Plan& plan, std::span<const double> node_costs, int processors,
                const Overheads& overheads)
      : plan_(plan),
        handover_(overheads.handover),
        durations_(cluster_times(plan, node_costs, overheads)),
        levels_(bottom_levels(plan, durations_)),
        waiting_for_(count_predecessors(plan)),
        made_ready_by_(durations_.size(), 0),
        idle_(at(processors), true),
        idle_count_(processors),
        schedule_{processors, 0.0, std::vector<Slot>(durations_.size())} {}

  Schedule run() && {
    for (int c = 0; c < plan_.cluster_count(); ++c) {
      if (waiting_for_[at(c)] == 0) ready_.emplace(levels_[at(c)], -c);
    }
    start_ready(0.0);
    while (!running_.empty()) {
      const double now = running_.top().first;
      while (!running_.empty() && running_.top().first == now) end_next();
      start_ready(now);
      schedule_.makespan = now;
    }
    return std::move(schedule_);
  }

 private:
  void start_ready(double now) {
    while (idle_count_ > 0 && !ready_.empty()) {
      const int cluster = -ready_.top().second;
      ready_.pop();
      const int maker = made_ready_by_[at(cluster)];
      const int processor =
          idle_[at(maker)]
              ? maker
              : static_cast<int>(std::find(idle_.begin(), idle_.end(), true) - idle_.begin());
      const double start = processor == maker ? now : now + handover_;
      schedule_.slots[at(cluster)] = {processor, start, start + durations_[at(cluster)]};
      running_.emplace(schedule_.slots[at(cluster)].end, cluster);
      idle_[at(processor)] = false;
      --idle_count_;
    }
  }

  void end_next() {
    const int cluster = running_.top().second;
    running_.pop();
    const int processor = schedule_.slots[at(cluster)].processor;
    idle_[at(processor)] = true;
    ++idle_count_;
    for (const int next : plan_.successors(cluster)) {
      if (--waiting_for_[at(next)] > 0) continue;
      made_ready_by_[at(next)] = processor;
      ready_.emplace(levels_[at(next)], -next);
    }
  }

  using Event = std::pair<double, int>;  // end [s], cluster

  const Plan& plan_;
  double handover_;
  std::vector<double> durations_;
  std::vector<double> levels_;
  std::vector<int> waiting_for_;
  std::vector<int> made_ready_by_;
  std::vector<bool> idle_;
  int idle_count_;
  std::priority_queue<std::pair<double, int>> ready_;  // bottom level, minus cluster: lower first
  std::priority_queue<Event, std::vector<Event>, std::greater<>> running_;
  Schedule schedule_;
};

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
        schedule_.slots[at(cluster)].processor = static_cast<int>(p);
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
    const std::vector<int>& list = lists_[at(processor)];
    std::size_t& next = done_[at(processor)];
    while (next < list.size() && waiting_for_[at(list[next])] == 0) run(list[next++]);
  }

  void run(int cluster) {
    Slot& slot = schedule_.slots[at(cluster)];
    double& free_at = free_at_[at(slot.processor)];
    const bool from_caller = plan_.predecessors(cluster).empty() && slot.processor != 0;
    slot.start = std::max(free_at, from_caller ? handover_ : 0.0);
    for (const int before : plan_.predecessors(cluster)) {
      const Slot& other = schedule_.slots[at(before)];
      const double delay = other.processor == slot.processor ? 0.0 : handover_;
      slot.start = std::max(slot.start, other.end + delay);
    }
    slot.end = free_at = slot.start + durations_[at(cluster)];
    schedule_.makespan = std::max(schedule_.makespan, slot.end);
    for (const int next : plan_.successors(cluster)) {
      const int processor = schedule_.slots[at(next)].processor;
      if (--waiting_for_[at(next)] == 0 && processor != slot.processor) {
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

double crowding(int clusters) {
  return std::min(static_cast<double>(clusters) / kManyClusters, 1.0);
}

std::vector<double> cluster_times(const Plan& plan, std::span<const double> node_costs,
                                  const Overheads& overheads) {
  std::vector<double> times = cluster_costs(plan, node_costs);
  const double per_cluster =
      overheads.per_cluster + crowding(plan.cluster_count()) * overheads.among_many;
  for (int c = 0; c < plan.cluster_count(); ++c) {
    times[at(c)] += per_cluster + overheads.per_node * static_cast<double>(plan.nodes(c).size());
  }
  return times;
}

double work_of(std::span<const double> node_costs) {
  return std::accumulate(node_costs.begin(), node_costs.end(), 0.0);
}

std::vector<double> bottom_levels(const Plan& plan, std::span<const double> costs_of_clusters) {
  std::vector<double> levels(costs_of_clusters.begin(), costs_of_clusters.end());
  for (int c = plan.cluster_count(); c-- > 0;) {
    double longest = 0.0;
    for (const int next : plan.successors(c)) longest = std::max(longest, levels[at(next)]);
    levels[at(c)] += longest;
  }
  return levels;
}

double span_of(const Plan& plan, std::span<const double> node_costs) {
  const auto levels = bottom_levels(plan, cluster_costs(plan, node_costs));
  return levels.empty() ? 0.0 : *std::max_element(levels.begin(), levels.end());
}

Schedule simulate_list_schedule(const Plan& plan, std::span<const double> node_costs,
                                int processors, const Overheads& overheads) {
  return ListScheduler(plan, node_costs, processors, overheads).run();
}

Schedule simulate_lists(const Plan& plan, std::span<const double> node_costs,
                        const ProcessorLists& lists, const Overheads& overheads) {
  return ListRunner(plan, node_costs, lists, overheads).run();
}

}  // namespace spoke::graph
