#include "graph/work_stealing.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "graph/counting_places.h"

namespace spoke::graph {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// The state of a schedule. What happens are ends of clusters, and looks: a processor without work
// looks at what another has kept.
class WorkStealer {
 public:
  WorkStealer(const Plan& plan, std::span<const double> node_costs, int processors,
              const Overheads& overheads, DataTraffic* traffic, Chance* chance,
              std::vector<int> places)
      : plan_(plan),
        node_costs_(node_costs),
        overheads_(overheads),
        traffic_(traffic),
        chance_(chance),
        durations_(cluster_times(plan, node_costs, overheads)),
        places_(places.empty() ? counting_places(plan, processors) : std::move(places)),
        counters_(places_.empty() ? 0 : at(1 + *std::max_element(places_.begin(), places_.end()))),
        processors_(at(processors)),
        schedule_{processors, 0.0, std::vector<Slot>(durations_.size())} {
    for (int c = 0; c < plan.cluster_count(); ++c)
      waiting_for_.push_back(static_cast<int>(plan.predecessors(c).size()));
    for (Processor& processor : processors_)
      processor.idle_since = -(chance_ ? chance_->from_0_to_1() : 0.5) * period();
  }

  Schedule run() && {
    start_roots();
    let_idle_look(0.0);
    while (!events_.empty()) {
      const Event event = events_.top();
      events_.pop();
      if (event.cluster < 0) {
        look(event.processor, event.time);
      } else {
        end(event.cluster, event.processor, event.time);
        schedule_.makespan = event.time;
      }
      let_idle_look(event.time);
    }
    return std::move(schedule_);
  }

 private:
  // The part of a handover that passes, in the mean, until a processor looks; the rest passes until
  // what it has taken is there.
  static constexpr double kSearch = 0.5;
  static constexpr double kVariation = 0.5;  // of waits

  enum class State { idle, looking, working };
  struct Processor {
    State state = State::idle;
    std::deque<int> kept;
    double idle_since = 0.0;  // it looks then, and after each period
    double list_used = 0.0;   // when it last put something into its list, or took it from there
    bool is_robbed = false;   // since then
  };
  struct Event {
    double time;  // s
    int processor;
    int cluster;  // that ends; -1 of a look
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

  double period() const { return 2.0 * kSearch * overheads_.handover; }
  double varied(double wait) const { return chance_ ? wait * chance_->factor(kVariation) : wait; }

  // The caller's list takes what the threads of an earlier run have left in their caches.
  void start_roots() {
    for (int c = plan_.cluster_count(); c-- > 0;) {
      if (waiting_for_[at(c)] == 0) keep(0, c);
    }
    const double wait = processors_.size() > 1 ? kept_count_ * overheads_.contention : 0.0;
    take_kept(0, varied(wait));
  }

  // The time at which the start that is made at `now` has been counted: one more under way, one
  // less. The counter comes from the processor that counted last, if that has had it long enough.
  double count_start(Counter& counter, int processor, double now) {
    if (processor == counter.holder) return now;
    counter.holder = processor;
    const double leaves = std::max(now, counter.free);
    counter.free = leaves + overheads_.counting;
    return leaves + varied(overheads_.contention);
  }

  void start(int cluster, int processor, double start) {
    double end = count_start(counters_[at(places_[at(cluster)])], processor, start) +
                 durations_[at(cluster)];
    if (traffic_) {
      for (const NodeId node : plan_.nodes(cluster))
        end += traffic_->run(node, processor, node_costs_[at(node.index)]);
    }
    schedule_.slots[at(cluster)] = {processor, start, end};
    events_.push({end, processor, cluster});
    processors_[at(processor)].state = State::working;
  }

  // With a cluster that no other processor has to find.
  void go_on(int cluster, int processor, double now) {
    start(cluster, processor, now + (traffic_ ? traffic_->start_cluster(cluster, processor) : 0.0));
  }

  void end(int cluster, int processor, double now) {
    int last_ready = -1;
    const int kept_before = kept_count_;
    const auto after = plan_.successors(cluster);
    for (std::size_t k = after.size(); k-- > 0;) {
      const int next = after[k];
      if (traffic_) now += traffic_->tell(next, processor);
      if (--waiting_for_[at(next)] > 0) continue;
      if (places_[at(next)] != places_[at(cluster)]) {
        keep(processor, next);
      } else {
        if (last_ready >= 0) keep(processor, last_ready);
        last_ready = next;
      }
    }
    if (kept_count_ > kept_before || last_ready < 0) now += wait_for_list(processor, now);
    if (last_ready >= 0) return go_on(last_ready, processor, now);
    processors_[at(processor)].state = State::idle;
    processors_[at(processor)].idle_since = now;
    take_kept(processor, now);
  }

  void keep(int processor, int cluster) {
    processors_[at(processor)].kept.push_back(cluster);
    ++kept_count_;
  }

  void take_kept(int processor, double now) {
    std::deque<int>& own = processors_[at(processor)].kept;
    if (own.empty()) return;
    const int cluster = own.back();
    own.pop_back();
    --kept_count_;
    go_on(cluster, processor, now + overheads_.keeping);
  }

  // A processor's own list comes back to it if another has looked at it.
  double wait_for_list(int processor, double now) {
    if (processors_.size() == 1) return 0.0;
    Processor& its = processors_[at(processor)];
    const double others = static_cast<double>(processors_.size()) - 1.0;
    const double looks = its.is_robbed ? 1.0 : looks_between(its.list_used, now) / others;
    its.is_robbed = false;
    its.list_used = now;
    return looks > 0.0 ? varied(std::min(looks, 1.0) * overheads_.contention) : 0.0;
  }

  // How often processors without work have looked somewhere, after `begin` and until `end`.
  double looks_between(double begin, double end) const {
    double looks = 0.0;
    for (const Processor& processor : processors_) {
      if (processor.state == State::working || period() == 0.0) continue;
      const auto looks_until = [&](double time) {
        return std::max(0.0, 1.0 + std::floor((time - processor.idle_since) / period()));
      };
      looks += looks_until(end) - looks_until(begin);
    }
    return looks;
  }

  void let_idle_look(double now) {
    if (kept_count_ == 0) return;
    for (std::size_t p = 0; p < processors_.size(); ++p) {
      Processor& processor = processors_[p];
      if (processor.state != State::idle) continue;
      processor.state = State::looking;
      const double periods =
          period() > 0.0 ? std::ceil((now - processor.idle_since) / period()) : 0.0;
      const double time = std::max(now, processor.idle_since + periods * period());
      events_.push({time, static_cast<int>(p), -1});
    }
  }

  void look(int processor, double now) {
    Processor& its = processors_[at(processor)];
    its.state = State::idle;
    if (kept_count_ == 0) return;
    Processor& other = processors_[at(any_other(processor))];
    if (other.kept.empty()) {
      its.state = State::looking;
      events_.push({now + period(), processor, -1});
      return;
    }
    const int cluster = other.kept.front();
    other.kept.pop_front();
    --kept_count_;
    other.is_robbed = true;
    if (traffic_) traffic_->start_cluster(cluster, processor);  // its wait is part of a handover
    start(cluster, processor, now + varied((1.0 - kSearch) * overheads_.handover));
  }

  int any_other(int processor) {
    const int others = static_cast<int>(processors_.size()) - 1;
    const int other = others > 1 ? victims_.below(others) : 0;
    return other < processor ? other : other + 1;
  }

  const Plan& plan_;
  std::span<const double> node_costs_;
  const Overheads overheads_;
  DataTraffic* traffic_;
  Chance* chance_;
  Chance victims_;
  std::vector<double> durations_;
  std::vector<int> places_;  // per cluster
  std::vector<Counter> counters_;
  std::vector<int> waiting_for_;
  std::vector<Processor> processors_;
  int kept_count_ = 0;  // by all of them
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  Schedule schedule_;
};

}  // namespace

Schedule simulate_work_stealing(const Plan& plan, std::span<const double> node_costs,
                                int processors, const Overheads& overheads, DataTraffic* traffic,
                                Chance* chance, std::vector<int> places) {
  return WorkStealer(plan, node_costs, processors, overheads, traffic, chance, std::move(places))
      .run();
}

}  // namespace spoke::graph
