#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graph/executor_kinds.h"
#include "graph/node_costs.h"
#include "graph/node_recorder.h"
#include "graph/overheads.h"
#include "graph/plan_candidates.h"
#include "graph/plan_choice.h"
#include "graph/quantiles.h"
#include "graph/runtime_costs.h"
#include "graph/time_stamp.h"
#include "graph/unbound_thread.h"

namespace spoke::graph {
namespace {

// Runs that are timed node by node: enough for a robust mean.
bool enough(const NodeCosts& costs) {
  constexpr int fewest = 4, usual = 8, most = 40;
  constexpr double short_time = 2e-3, long_time = 0.1;  // s
  if (costs.runs() < fewest) return false;
  return costs.runs() >= most || costs.seconds() >= long_time ||
         (costs.runs() >= usual && costs.seconds() >= short_time);
}

// One way to run the graph that takes turns with the others.
struct Alternative {
  std::unique_ptr<Executor> executor;
  int clusters = 1;
  double foreseen = 1.0;  // speedup
  Samples samples;        // s per run
};

// How much time the alternatives get to take turns.
struct Effort {
  int timed_runs = 1;    // per turn
  int warm_up_runs = 0;  // before them: threads that slept are slow to begin
  int rounds = 0;
};

Effort effort_for(double seconds_per_run, std::size_t alternatives) {
  constexpr double turn = 1.5e-3, all = 0.5;  // s
  constexpr double fewest_rounds = 3.0, most_rounds = 9.0;
  Effort effort;
  const double runs = std::clamp(std::ceil(turn / std::max(seconds_per_run, 1e-7)), 1.0, 10000.0);
  effort.timed_runs = static_cast<int>(runs);
  if (effort.timed_runs > 1) effort.warm_up_runs = (effort.timed_runs + 3) / 4;
  const double seconds = (effort.timed_runs + effort.warm_up_runs) * seconds_per_run;
  effort.rounds = static_cast<int>(
      std::clamp(all / (seconds * static_cast<double>(alternatives)), fewest_rounds, most_rounds));
  return effort;
}

std::string text_of(const char* format, auto... values) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return text_of("%.3g us", seconds * 1e6);
  return seconds < 1.0 ? text_of("%.3g ms", seconds * 1e3) : text_of("%.3g s", seconds);
}

// Every run is a real one, whatever it serves: node costs first, then turns of the best plans, then
// the winner.
class AutoExecutor final : public Executor {
 public:
  AutoExecutor(const StepGraph& graph, int threads) : graph_(graph), threads_(threads) {
    processors_ = std::min(threads, available_threads());
    if (processors_ <= 1) {
      settle_serial("serial: one thread");
    } else if (graph.node_count() <= 1) {
      settle_serial("serial: nothing to share");
    } else {
      costs_.emplace(graph);
    }
  }

  void run() override {
    if (recorder() != nullptr) return run_recorded();
    ++runs_;
    if (chosen_ && runs_ == next_tuning_) tune_again();
    if (chosen_) {
      chosen_->run();
    } else if (costs_) {
      measure_costs();
    } else {
      take_turn();
    }
  }
  std::string_view name() const override { return name_of(ExecutorKind::automatic); }
  Threads threads() const override { return threads_; }
  std::string describe() const override {
    return chosen_ ? description_ : "still tuning on " + name_of(threads()) + " threads";
  }
  bool tuning() const override { return !chosen_; }
  int choices() const override { return choices_; }
  Threads recorded_threads() const override { return chosen_ ? chosen_->threads() : Threads(1); }
  bool settled_on_serial() const override { return chosen_ && is_serial_ && next_tuning_ <= runs_; }

  void set_recorder(NodeRecorder* recorder) override {
    Executor::set_recorder(recorder);
    if (chosen_) chosen_->set_recorder(recorder);
  }

 private:
  // Time stamps cost time: what is recorded is not weighed. Until something is chosen, it runs
  // serially.
  void run_recorded() {
    if (chosen_) return chosen_->run();
    run_nodes(graph_, recorder(), 0, -1, graph_.serial_order(),
              [this](NodeId node) { graph_.run_node(node); });
  }

  void tune_again() {
    chosen_.reset();
    costs_.emplace(graph_);
  }

  void settle_serial(std::string description) {
    chosen_ = make_serial_executor(graph_);
    is_serial_ = true;
    description_ = std::move(description);
    ++choices_;
  }

  void measure_costs() {
    costs_->run();
    if (!enough(*costs_)) return;
    const double seconds_per_run = costs_->seconds() / costs_->runs();
    make_alternatives(costs_->costs(), seconds_per_run);
    costs_.reset();
    if (alternatives_.size() > 1) {
      effort_ = effort_for(seconds_per_run, alternatives_.size());
    } else {
      settle_serial(text_of("serial: 1 run takes %s, none of %d plans promised a gain",
                            duration(seconds_per_run).c_str(), tried_));
      alternatives_.clear();
    }
  }

  void make_alternatives(const std::vector<double>& costs, double seconds_per_run) {
    const UnboundThread unbound;  // oneTBB's threads get the processors that this one has
    // Where single runs are long the model is good, and trials are dear.
    const std::size_t per_ordering = seconds_per_run > 10e-3 ? 1 : 2;
    // A plan may turn out better than foreseen, but not by that much.
    const double work = work_of(costs);
    const double acceptable = 1.2 * work;
    best_foreseen_ = 0.0;
    alternatives_.push_back({make_serial_executor(graph_), 1, 1.0, {}});
    const auto is_unacceptable = [=](const Candidate& c) { return c.makespan > acceptable; };
    std::vector<Candidate> candidates = find_candidates(
        graph_, costs, processors_, flow_graph_overheads(), weighable_candidates(graph_), &tried_);
    std::erase_if(candidates, is_unacceptable);
    if (candidates.empty()) return;  // spares measuring what weighing takes
    candidates = weigh_candidates(std::move(candidates), graph_, costs, processors_,
                                  flow_graph_costs(), per_ordering);
    std::erase_if(candidates, is_unacceptable);
    for (Candidate& candidate : candidates) {
      const double foreseen = work / candidate.makespan;
      best_foreseen_ = std::max(best_foreseen_, foreseen);
      const int clusters = candidate.plan.cluster_count();
      alternatives_.push_back(
          {make_flow_graph_executor(graph_, std::move(candidate.plan), processors_),
           clusters,
           foreseen,
           {}});
    }
  }

  void take_turn() {
    const std::size_t count = alternatives_.size();
    // The first to take a turn moves on with the rounds.
    Alternative& alternative = alternatives_[(turn_ + static_cast<std::size_t>(round_)) % count];
    const std::uint64_t begin = time_stamp();
    alternative.executor->run();
    if (run_of_turn_ >= effort_.warm_up_runs) ticks_ += time_stamp() - begin;
    if (++run_of_turn_ < effort_.warm_up_runs + effort_.timed_runs) return;
    alternative.samples.push_back(static_cast<double>(std::exchange(ticks_, 0)) *
                                  time_stamp_scale().seconds_per_tick / effort_.timed_runs);
    run_of_turn_ = 0;
    if (++turn_ < count) return;
    turn_ = 0;
    if (++round_ == effort_.rounds) settle();
  }

  void settle() {
    std::vector<Samples> samples;
    std::vector<double> foreseen;
    for (const Alternative& alternative : alternatives_) {
      samples.push_back(alternative.samples);
      foreseen.push_back(alternative.foreseen);
    }
    const double seconds = median(samples[0]);
    const Choice choice =
        choose_plan(samples, foreseen, least_gain(seconds, flow_graph_overheads().handover));
    doubt(choice);
    if (choice.index == 0) {
      description_ = text_of("serial: 1 run takes %s, the best of %d plans was %.2g x",
                             duration(seconds).c_str(), tried_, choice.speedup);
    } else {
      description_ = text_of("%d threads, %d clusters of %d nodes (%s serial, %s so: %.2f x)",
                             processors_, alternatives_[choice.index].clusters, graph_.node_count(),
                             duration(seconds).c_str(), duration(seconds / choice.speedup).c_str(),
                             choice.speedup);
    }
    chosen_ = std::move(alternatives_[choice.index].executor);
    is_serial_ = choice.index == 0;
    ++choices_;
    alternatives_.clear();
    round_ = 0;
  }

  // A gain that was foreseen and not found, or found and not foreseen, tells of a machine busy with
  // other things: tunes again, soon at first, then after many times as many runs, so that it costs
  // little if it was true.
  void doubt(const Choice& choice) {
    constexpr double doubtful = 1.3;  // one / the other
    constexpr std::uint64_t soon = 4, late = 20;
    if (best_foreseen_ <= doubtful * choice.speedup && choice.speedup <= doubtful * choice.foreseen)
      return;
    next_tuning_ = std::exchange(doubted_, true) ? late * runs_ : soon * runs_;
  }

  const StepGraph& graph_;
  int threads_;
  int processors_ = 1;
  std::unique_ptr<Executor> chosen_;  // none while tuning
  bool is_serial_ = false;            // what is chosen
  std::string description_;
  int choices_ = 0;
  std::uint64_t runs_ = 0;
  std::uint64_t next_tuning_ = 0;  // in runs_, 0 = never
  bool doubted_ = false;           // once

  std::optional<NodeCosts> costs_;         // in the first phase
  std::vector<Alternative> alternatives_;  // in the second phase, the serial one first
  int tried_ = 0;
  double best_foreseen_ = 0.0;  // speedup by the simulator
  Effort effort_;
  int round_ = 0;
  std::size_t turn_ = 0;  // within the round
  int run_of_turn_ = 0;
  std::uint64_t ticks_ = 0;  // of the turn's timed runs
};

}  // namespace

std::unique_ptr<Executor> make_auto_executor(const StepGraph& graph, int threads) {
  return std::make_unique<AutoExecutor>(graph, threads);
}

}  // namespace spoke::graph
