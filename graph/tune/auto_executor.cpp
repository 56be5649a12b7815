// The alternatives that auto tries for a graph, their times, and the budget for trials.

#include "graph/tune/auto_executor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "graph/calibrate/node_costs.h"
#include "graph/calibrate/quantiles.h"
#include "graph/execute/executor_kinds.h"
#include "graph/execute/node_recorder.h"
#include "graph/execute/unbound_thread.h"
#include "graph/machine/duration_text.h"
#include "graph/machine/time_stamp.h"
#include "graph/tune/capacity_probes.h"
#include "graph/tune/plan_candidates.h"

namespace spoke::graph {
namespace {

// s by which a plan may be slower than serial runs, summed up, before it is left
constexpr double kLeastAllowance = 1e-3, kMostAllowance = 4e-3;
constexpr double kTurn = 1e-3;           // s, length of a turn of runs
constexpr std::size_t kTimedTurns = 5;   // turns whose median counts, and ...
constexpr std::size_t kFewestTurns = 3;  // ... how many say which alternative is the faster one
constexpr std::size_t kMostPlans = 3;
// The share of the time of all runs up to which alternatives that have proved slower are tried
// again.
constexpr double kRepeatShare = kTuningShare / 4;

// Whether enough runs were timed node by node for a robust mean.
bool is_enough(const NodeCosts& costs) {
  constexpr int fewest = 4, usual = 8;
  constexpr double short_time = 0.5e-3, long_time = 20e-3;  // s
  if (costs.runs() < fewest) return false;
  return costs.seconds() >= long_time || (costs.runs() >= usual && costs.seconds() >= short_time);
}

std::string text_of(const char* format, auto... values) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

// One way to run the graph.
struct Alternative {
  std::unique_ptr<Executor> executor;
  int clusters = 1;
  double predicted = 0.0;     // s per run
  std::vector<double> turns;  // s per run, of the latest kTimedTurns turns
  double seconds() const { return turns.empty() ? predicted : median(turns); }
  bool is_timed() const { return turns.size() >= kFewestTurns; }
};

class AutoExecutor final : public Executor {
 public:
  AutoExecutor(const StepGraph& graph, int threads, Expectation expectation)
      : graph_(graph),
        threads_(threads),
        expected_seconds_(expectation.seconds),
        processors_(std::min(threads, available_threads())),
        threads_are_worth_(expectation.threads_are_worth),
        probes_(processors_, expectation.seconds) {
    assert(threads >= 1);
    alternatives_.push_back({make_serial_executor(graph), 1, 0.0, {}});
    if (processors_ <= 1) {
      stay_serial("serial: one thread");
    } else if (graph.node_count() <= 1) {
      stay_serial("serial: nothing to share");
    } else if (!expectation.node_costs.empty()) {
      plan(expectation.node_costs);
    } else {
      costs_.emplace(graph);
    }
  }

  void run() override {
    if (recorder() != nullptr) return run_recorded();
    if (costs_) return measure_costs();
    if (is_final_) return running().executor->run();
    const std::uint64_t begin = time_stamp();
    running().executor->run();
    account(seconds_since(begin));
  }
  std::string_view name() const override { return name_of(ExecutorKind::automatic); }
  Threads threads() const override { return threads_; }
  std::string describe() const override;
  bool tuning() const override { return costs_.has_value(); }
  int choices() const override { return choices_; }
  Threads recorded_threads() const override { return alternatives_[chosen_].executor->threads(); }
  bool settled_on_serial() const override { return is_final_; }

  void set_recorder(NodeRecorder* recorder) override {
    Executor::set_recorder(recorder);
    alternatives_[chosen_].executor->set_recorder(recorder);
  }

 private:
  Alternative& running() { return alternatives_[running_]; }
  const Alternative& serial() const { return alternatives_.front(); }

  // Runs with a recorder. Recording takes time, so these runs are not timed.
  void run_recorded() { alternatives_[chosen_].executor->run(); }

  void stay_serial(std::string reason) {
    is_final_ = true;
    reason_ = std::move(reason);
    choose(0);
  }

  void measure_costs() {
    costs_->run();
    if (!is_enough(*costs_)) return;
    elapsed_ += costs_->seconds();
    const std::vector<double> costs = costs_->costs();
    costs_.reset();
    plan(costs);
  }

  void plan(const std::vector<double>& costs);
  void account(double seconds);
  void end_turn();
  void start_turn(std::size_t alternative);
  std::size_t next_alternative();
  bool can_pay(const Alternative& trial) const;
  void leave_plan();
  bool find_worth();

  void choose(std::size_t alternative) {
    if (choices_ == 0 || alternative != chosen_) ++choices_;
    chosen_ = alternative;
  }
  // Returns the time that tuning may still take [s].
  double budget() const { return kTuningShare * std::max(expected_seconds_, elapsed_) - spent_; }

  const StepGraph& graph_;
  int threads_;
  double expected_seconds_;
  int processors_;
  bool threads_are_worth_;  // whether other threads are worth it, to begin with
  CapacityProbes probes_;
  std::optional<NodeCosts> costs_;         // while they are measured
  std::vector<Alternative> alternatives_;  // alternatives, the serial one first
  std::size_t chosen_ = 0, running_ = 0;
  bool is_final_ = false;  // whether serial runs were chosen for good
  std::string reason_;     // reason for serial runs
  int choices_ = 0;

  double elapsed_ = 0.0;       // s, time of all runs
  double spent_ = 0.0;         // s, time of planning, probes, trials and slow plans
  double lost_ = 0.0;          // s, lost by the chosen plan since it was slower than serial runs
  double gained_ = 0.0;        // s, gained by plans since serial runs were left
  double turn_seconds_ = 0.0;  // s, time of the turn's runs
  int turn_runs_ = 0, runs_in_turn_ = 1;
  std::size_t next_trial_ = 0;
};

void AutoExecutor::plan(const std::vector<double>& costs) {
  const std::uint64_t begin = time_stamp();
  const UnboundThread unbound;  // oneTBB's threads get the processors that this one has
  const Overheads overheads;
  const double work = work_of(costs);
  alternatives_.front().predicted = work;
  const double acceptable = work / least_gain(work, overheads.handover);
  auto candidates = find_candidates(graph_, costs, processors_, overheads, kMostPlans);
  std::erase_if(candidates, [=](const Candidate& c) { return c.makespan > acceptable; });
  for (Candidate& candidate : candidates) {
    const int clusters = candidate.plan.cluster_count();
    alternatives_.push_back(
        {make_flow_graph_executor(graph_, std::move(candidate.plan), processors_),
         clusters,
         candidate.makespan,
         {}});
  }
  if (alternatives_.size() == 1) {
    stay_serial(
        text_of("serial: 1 run takes %s, no plan promised a gain", duration_text(work).c_str()));
  } else {
    const std::size_t first = threads_are_worth_ || find_worth() ? 1 : 0;
    choose(first);
    start_turn(first);
  }
  spent_ += seconds_since(begin);
}

// Finds whether the machine has a processor for other threads at present.
bool AutoExecutor::find_worth() {
  const bool are_worth = probes_.find_worth(elapsed_);
  if (!are_worth) reason_ = "serial: " + probes_.describe();
  return are_worth;
}

void AutoExecutor::start_turn(std::size_t alternative) {
  running_ = alternative;
  turn_seconds_ = 0.0;
  turn_runs_ = 0;
  const double runs = kTurn / std::max(running().seconds(), 1e-7);
  runs_in_turn_ = static_cast<int>(std::clamp(runs, 1.0, 10000.0));
}

// Each run is weighed against a serial one at once: a thread that waits for a processor may take
// milliseconds.
void AutoExecutor::account(double seconds) {
  elapsed_ += seconds;
  turn_seconds_ += seconds;
  ++turn_runs_;
  if (running_ != 0) {
    const double loss = seconds - serial().seconds();
    gained_ -= loss;
    lost_ = std::max(0.0, lost_ + loss);
    if (lost_ > std::clamp(0.25 * budget(), kLeastAllowance, kMostAllowance)) return leave_plan();
  }
  if (turn_runs_ >= runs_in_turn_) end_turn();
}

void AutoExecutor::leave_plan() {
  spent_ += lost_;
  lost_ = 0.0;
  reason_ = text_of("serial: the plan of %d clusters was slower at present",
                    alternatives_[running_].clusters);
  for (Alternative& alternative : alternatives_) alternative.turns.clear();
  // A passing disturbance met a plan that had been worth it.
  probes_.begin_pause(elapsed_, gained_ > 0.0);
  gained_ = 0.0;
  choose(0);
  start_turn(0);
}

void AutoExecutor::end_turn() {
  Alternative& alternative = running();
  const double seconds = turn_seconds_ / turn_runs_;
  if (running_ != chosen_)
    spent_ += std::max(0.0, turn_seconds_ - turn_runs_ * alternatives_[chosen_].seconds());
  if (alternative.turns.size() == kTimedTurns) alternative.turns.erase(alternative.turns.begin());
  alternative.turns.push_back(seconds);
  start_turn(next_alternative());
}

// Returns the chosen alternative, or another one in turn if the budget allows it.
std::size_t AutoExecutor::next_alternative() {
  if (chosen_ == 0) {
    if (probes_.pause_left(elapsed_) > 0.0) return 0;
    const std::uint64_t begin = time_stamp();
    const bool are_worth = find_worth();
    spent_ += seconds_since(begin);
    if (!are_worth) return 0;
    choose(1);
    return 1;
  }
  if (running_ != 0 && running_ != chosen_ && running().is_timed() &&
      alternatives_[chosen_].is_timed() &&
      running().seconds() < 0.99 * alternatives_[chosen_].seconds())
    choose(running_);
  if (running_ != chosen_) return chosen_;
  for (std::size_t k = 0; k < alternatives_.size(); ++k) {
    const std::size_t trial = next_trial_++ % alternatives_.size();
    if (can_pay(alternatives_[trial])) return trial;
  }
  return chosen_;
}

// Returns whether a turn is within the budget that is left.
bool AutoExecutor::can_pay(const Alternative& trial) const {
  const double cost =
      kTurn * std::max(0.0, 1.0 - alternatives_[chosen_].seconds() / trial.seconds());
  const double left = trial.is_timed() ? kRepeatShare * elapsed_ - spent_ : budget();
  return left >= cost + 0.1 * kTurn;
}

std::string AutoExecutor::describe() const {
  if (costs_) return "still tuning on " + name_of(threads()) + " threads";
  if (chosen_ == 0) return reason_;
  const Alternative& plan = alternatives_[chosen_];
  const double before = serial().seconds(), now = plan.seconds();
  return text_of("%d threads, %d clusters of %d nodes (%s serial, %s so: %.2f x)", processors_,
                 plan.clusters, graph_.node_count(), duration_text(before).c_str(),
                 duration_text(now).c_str(), before / now);
}

}  // namespace

std::unique_ptr<Executor> make_auto_executor(const StepGraph& graph, int threads,
                                             Expectation expectation) {
  return std::make_unique<AutoExecutor>(graph, threads, std::move(expectation));
}

}  // namespace spoke::graph
