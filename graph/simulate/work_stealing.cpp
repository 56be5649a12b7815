// The events of a run by work stealing: ends of clusters, and thefts.

#include "graph/simulate/work_stealing.h"

#include <cassert>
#include <deque>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

// The state of a schedule. Its events are ends of clusters, and thefts.
class WorkStealer {
 public:
  WorkStealer(const Plan& plan, std::span<const double> node_costs, int processors,
              const Overheads& overheads)
      : plan_(plan),
        overheads_(overheads),
        durations_(cluster_times(plan, node_costs, overheads)),
        processors_(index_of(processors)),
        schedule_{processors, 0.0, std::vector<Slot>(durations_.size())} {
    for (int c = 0; c < plan.cluster_count(); ++c)
      waiting_for_.push_back(static_cast<int>(plan.predecessors(c).size()));
  }

  Schedule run() && {
    for (int c = plan_.cluster_count(); c-- > 0;) {
      if (waiting_for_[index_of(c)] == 0) spawn(0, c);
    }
    take_spawned(0, 0.0);
    let_idle_steal(0.0);
    while (!events_.empty()) {
      const Event event = events_.top();
      events_.pop();
      if (event.cluster == kTheft) {
        try_steal(event.processor, event.time);
      } else {
        end(event.cluster, event.processor, event.time);
        schedule_.makespan = event.time;
      }
      let_idle_steal(event.time);
    }
    return std::move(schedule_);
  }

 private:
  static constexpr int kTheft = -1;
  // The part of a handover that passes until a thief has found the victim; in the rest, the stolen
  // cluster's data come to it.
  static constexpr double kSearch = 0.5;

  enum class State { idle, stealing, working };
  struct Processor {
    State state = State::idle;
    std::deque<int> ready;
  };
  struct Event {
    double time;  // s
    int processor;
    int cluster;  // the cluster that ends, or kTheft
    bool operator>(const Event& other) const {
      return std::tie(time, cluster, processor) >
             std::tie(other.time, other.cluster, other.processor);
    }
  };

  void start(int cluster, int processor, double now) {
    const double end = now + durations_[index_of(cluster)];
    schedule_.slots[index_of(cluster)] = {processor, now, end};
    events_.push({end, processor, cluster});
    processors_[index_of(processor)].state = State::working;
  }

  void end(int cluster, int processor, double now) {
    int next_cluster = -1;
    const auto after = plan_.successors(cluster);
    for (auto next = after.rbegin(); next != after.rend(); ++next) {
      if (--waiting_for_[index_of(*next)] > 0) continue;
      if (next_cluster >= 0) spawn(processor, next_cluster);
      next_cluster = *next;
    }
    if (next_cluster >= 0) return start(next_cluster, processor, now);
    processors_[index_of(processor)].state = State::idle;
    take_spawned(processor, now);
  }

  void spawn(int processor, int cluster) {
    processors_[index_of(processor)].ready.push_back(cluster);
    ++spawned_;
  }

  void take_spawned(int processor, double now) {
    std::deque<int>& own = processors_[index_of(processor)].ready;
    if (own.empty()) return;
    const int cluster = own.back();
    own.pop_back();
    --spawned_;
    start(cluster, processor, now);
  }

  void let_idle_steal(double now) {
    if (spawned_ == 0) return;
    for (std::size_t p = 0; p < processors_.size(); ++p) {
      if (processors_[p].state != State::idle) continue;
      processors_[p].state = State::stealing;
      events_.push({now + kSearch * overheads_.handover, static_cast<int>(p), kTheft});
    }
  }

  void try_steal(int thief, double now) {
    processors_[index_of(thief)].state = State::idle;
    const std::size_t count = processors_.size();
    for (std::size_t k = 1; k < count; ++k) {
      std::deque<int>& ready = processors_[(index_of(thief) + k) % count].ready;
      if (ready.empty()) continue;
      const int cluster = ready.front();
      ready.pop_front();
      --spawned_;
      return start(cluster, thief, now + (1.0 - kSearch) * overheads_.handover);
    }
  }

  const Plan& plan_;
  const Overheads overheads_;
  std::vector<double> durations_;
  std::vector<int> waiting_for_;
  std::vector<Processor> processors_;
  int spawned_ = 0;  // number of clusters in all deques
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  Schedule schedule_;
};

}  // namespace

Schedule simulate_work_stealing(const Plan& plan, std::span<const double> node_costs,
                                int processors, const Overheads& overheads) {
  assert(processors >= 1);
  return WorkStealer(plan, node_costs, processors, overheads).run();
}

}  // namespace spoke::graph
