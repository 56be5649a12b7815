#include "graph/schedule_simulator.h"

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "graph/counting_places.h"

namespace spoke::graph {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Per cluster its cost with overheads, but without handovers [s].
std::vector<double> durations(const Plan& plan, std::span<const double> node_costs,
                              const Overheads& overheads) {
  std::vector<double> times = cluster_costs(plan, node_costs);
  for (int c = 0; c < plan.cluster_count(); ++c) {
    times[at(c)] +=
        overheads.per_cluster + overheads.per_node * static_cast<double>(plan.nodes(c).size());
  }
  return times;
}

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
        durations_(durations(plan, node_costs, overheads)),
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

// The state of a schedule by work stealing. What happens are ends of clusters, and finds: a
// processor without work has come upon what another has kept.
class WorkStealer {
 public:
  WorkStealer(const Plan& plan, std::span<const double> node_costs, int processors,
              const Overheads& overheads, DataTraffic* traffic)
      : plan_(plan),
        traffic_(traffic),
        handover_(overheads.handover),
        contention_(overheads.contention),
        counting_(overheads.counting),
        durations_(durations(plan, node_costs, overheads)),
        places_(counting_places(plan, processors)),
        counters_(places_.empty() ? 0 : at(1 + *std::max_element(places_.begin(), places_.end()))),
        waiting_for_(count_predecessors(plan)),
        kept_(at(processors)),
        states_(at(processors), State::idle),
        counts_{processors},
        schedule_{processors, 0.0, std::vector<Slot>(durations_.size())} {}

  Schedule run() && {
    for (int c = 0; c < plan_.cluster_count(); ++c) {
      if (waiting_for_[at(c)] == 0) keep(0, c);
    }
    take_kept(0, wait_to_keep(kept_count_));
    let_idle_search(0.0);
    while (!events_.empty()) {
      const Event event = events_.top();
      events_.pop();
      if (event.cluster < 0) {
        find(event.processor, event.time);
      } else {
        end(event.cluster, event.processor, event.time);
        schedule_.makespan = event.time;
      }
      let_idle_search(event.time);
    }
    return std::move(schedule_);
  }

 private:
  // A searching processor finds what there is after this part of a handover, and takes it; what it
  // needs of it arrives in the rest.
  static constexpr double kSearch = 0.25;

  enum class State { idle, searching, working };
  static constexpr int kStates = 3;
  struct Event {
    double time;  // s
    int processor;
    int cluster;  // that ends; -1 of a find
    bool operator>(const Event& other) const {
      return std::tie(time, cluster, processor) >
             std::tie(other.time, other.cluster, other.processor);
    }
  };

  // A place of counting.
  struct Counter {
    int holder = 0;     // the processor that counted last
    double free = 0.0;  // when it can go to another [s]
  };

  // The time at which the start that is made at `now` has been counted: one more under way, one
  // less. The counter comes from the processor that counted last, if that has had it long enough.
  double count_start(Counter& counter, int processor, double now) {
    if (processor == counter.holder) return now;
    counter.holder = processor;
    const double leaves = std::max(now, counter.free);
    counter.free = leaves + counting_;
    return leaves + contention_;
  }

  void start(int cluster, int processor, double start) {
    double end = count_start(counters_[at(places_[at(cluster)])], processor, start) +
                 durations_[at(cluster)];
    if (traffic_) {
      for (const NodeId node : plan_.nodes(cluster)) end += traffic_->run(node, processor);
    }
    schedule_.slots[at(cluster)] = {processor, start, end};
    events_.push({end, processor, cluster});
    change(processor, State::working);
  }

  void change(int processor, State state) {
    State& its = states_[at(processor)];
    --count(its);
    ++count(state);
    its = state;
  }
  int& count(State state) { return counts_[static_cast<std::size_t>(state)]; }

  void keep(int processor, int cluster) {
    kept_[at(processor)].push_back(cluster);
    ++kept_count_;
  }

  // While another processor searches, it keeps taking the list of what is kept away. All are idle
  // before the run has begun.
  double wait_to_keep(int clusters) const {
    const int working = counts_[static_cast<std::size_t>(State::working)];
    return working < static_cast<int>(states_.size()) && states_.size() > 1 ? clusters * contention_
                                                                            : 0.0;
  }

  void end(int cluster, int processor, double now) {
    int last_ready = -1;
    const int kept_before = kept_count_;
    for (const int next : plan_.successors(cluster)) {
      if (--waiting_for_[at(next)] > 0) continue;
      if (places_[at(next)] != places_[at(cluster)]) {
        keep(processor, next);
      } else {
        if (last_ready >= 0) keep(processor, last_ready);
        last_ready = next;
      }
    }
    now += wait_to_keep(kept_count_ - kept_before);
    if (last_ready >= 0) return go_on(last_ready, processor, now);
    const double wait = wait_to_keep(1);
    change(processor, State::idle);
    take_kept(processor, now + wait);
  }

  // With a cluster that no other processor had to find.
  void go_on(int cluster, int processor, double now) {
    start(cluster, processor, now + wait_for_record(cluster, processor));
  }
  double wait_for_record(int cluster, int processor) {
    return traffic_ ? traffic_->start_cluster(cluster, processor) : 0.0;
  }

  void take_kept(int processor, double now) {
    std::deque<int>& own = kept_[at(processor)];
    if (own.empty()) return;
    go_on(own.back(), processor, now);
    own.pop_back();
    --kept_count_;
  }

  // As many as there is something for: more would find nothing.
  void let_idle_search(double now) {
    const auto is_enough = [&] {
      return count(State::idle) == 0 || count(State::searching) >= kept_count_;
    };
    for (int p = 0; !is_enough(); ++p) {
      if (states_[at(p)] != State::idle) continue;
      change(p, State::searching);
      events_.push({now + kSearch * handover_, p, -1});
    }
  }

  void find(int processor, double now) {
    change(processor, State::idle);
    const auto victim = std::find_if(kept_.begin(), kept_.end(),
                                     [](const std::deque<int>& kept) { return !kept.empty(); });
    if (victim == kept_.end()) return;
    wait_for_record(victim->front(), processor);  // is part of a handover
    start(victim->front(), processor, now + (1.0 - kSearch) * handover_);
    victim->pop_front();
    --kept_count_;
  }

  const Plan& plan_;
  DataTraffic* traffic_;
  double handover_;
  double contention_;
  double counting_;
  std::vector<double> durations_;
  std::vector<int> places_;  // per cluster
  std::vector<Counter> counters_;
  std::vector<int> waiting_for_;
  std::vector<std::deque<int>> kept_;  // per processor
  int kept_count_ = 0;
  std::vector<State> states_;        // per processor
  std::array<int, kStates> counts_;  // of processors, per state
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
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
        durations_(durations(plan, node_costs, overheads)),
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

Schedule simulate_work_stealing(const Plan& plan, std::span<const double> node_costs,
                                int processors, const Overheads& overheads, DataTraffic* traffic) {
  return WorkStealer(plan, node_costs, processors, overheads, traffic).run();
}

Schedule simulate_lists(const Plan& plan, std::span<const double> node_costs,
                        const ProcessorLists& lists, const Overheads& overheads) {
  return ListRunner(plan, node_costs, lists, overheads).run();
}

}  // namespace spoke::graph
