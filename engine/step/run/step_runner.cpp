// Times the first steps, chooses the window, and runs steps by the graph and executor that fit.

#include "engine/step/run/step_runner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/step/run/step_recording.h"
#include "engine/step/step_graph_builder.h"
#include "graph/calibrate/quantiles.h"
#include "graph/tune/auto_executor.h"
#include "spoke/error.h"

namespace spoke {
namespace {

using graph::ExecutorKind;

// A step shorter than this takes no longer than handing its parts to threads.
constexpr double kLongStep = 40e-6;  // s
// Building a graph and planning its runs takes so long for each of its nodes.
constexpr double kBuildingPerNode = 4e-6;  // s
// Starting and ending a run on several threads takes so long beside its nodes.
constexpr double kRunOverhead = 3e-6;  // s
// Runs longer than this gain nothing more, and graphs larger than this leave the nearer caches.
constexpr double kLongestRun = 600e-6;  // s
constexpr int kMostNodes = 12000;
// The remaining steps must take as many times as long as the building of one pass's graph, or of
// the window's.
constexpr double kLeastPayback = 10.0;

constexpr int kBatch = 8;                 // steps that are timed together
constexpr double kTimingLength = 400e-6;  // s

graph::Threads resolved(graph::Threads threads) {
  if (threads.outer == 0) threads.outer = graph::available_threads();
  return threads;
}

/// Throws InputError if OpenMP would not give them.
graph::Threads allowed_threads(const RunnerOptions& options) {
  const graph::Threads threads = resolved(options.threads);
  graph::check_thread_limit(options.executor, threads);
  return threads;
}

/// Lets a recording follow an executor and a stepper while it lives.
class RecordingScope {
 public:
  RecordingScope(graph::Executor& executor, TimeStepper& stepper, StepRecording& recording,
                 bool together)
      : executor_(executor), stepper_(stepper) {
    executor.set_recorder(&recording.recorder());
    stepper.watch_runs(&recording, together);
  }
  RecordingScope(const RecordingScope&) = delete;
  RecordingScope& operator=(const RecordingScope&) = delete;
  ~RecordingScope() {
    stepper_.watch_runs(nullptr);
    executor_.set_recorder(nullptr);
  }

 private:
  graph::Executor& executor_;
  TimeStepper& stepper_;
};

/// Makes an executor of the kind asked for, or of the caller's own.
std::unique_ptr<graph::Executor> make_asked(const graph::StepGraph& graph,
                                            const RunnerOptions& options,
                                            const graph::Threads& threads) {
  if (!options.make_executor) return graph::make_executor(graph, options.executor, threads);
  std::unique_ptr<graph::Executor> made = options.make_executor(graph);
  if (!made) throw InputError("SimulationOptions::make_executor made none, expected an executor");
  const graph::Threads count = made->threads();
  if (count.outer < 1 || count.inner < 1 || count.total() > graph::kMostThreads)
    throw InputError("the executor " + std::string(made->name()) + " has " + name_of(count) +
                     " threads, expected 1 to " + std::to_string(graph::kMostThreads));
  return made;
}

/// Returns the options of the runner of a single pass.
RunnerOptions single_options(RunnerOptions options) {
  if (options.executor == ExecutorKind::automatic && !options.is_shared)
    options.executor = ExecutorKind::serial;
  return options;
}

}  // namespace

int window_records(const RunnerOptions& options, double bytes_per_step) {
  assert(bytes_per_step > 0.0 && options.window >= 0);
  // There are twice as many records as steps: a subsystem that is ahead need not wait for the
  // others.
  if (options.window > 0) return options.window > 1 ? 2 * options.window : 1;
  // Steps write to one record after the other: those of one process stay in the nearer caches,
  // while processes have less to say to one another the more steps they make at once.
  constexpr double near_bytes = 4e5, shared_bytes = 4e6;
  const auto fitting = [bytes_per_step](double bytes) {
    return static_cast<int>(std::clamp(bytes / bytes_per_step, 4.0, 1024.0));
  };
  if (options.is_shared) return std::min(fitting(shared_bytes), kMostSharedSteps);
  if (options.executor != ExecutorKind::automatic || resolved(options.threads).total() == 1)
    return 1;
  return fitting(near_bytes);
}

StepRunner::Runner::Runner(StepContext& context, int passes, const RunnerOptions& options,
                           graph::Threads threads)
    : graph(context.build_graph(passes)), executor(make_asked(graph, options, threads)) {}

StepRunner::Runner::Runner(StepContext& context, int passes, double passes_per_step)
    : graph(context.build_graph(passes)),
      steps(std::max(1, static_cast<int>(passes / passes_per_step))) {}

StepRunner::StepRunner(StepContext& context, const RunnerOptions& options)
    : context_(context),
      options_(options),
      threads_(allowed_threads(options)),
      single_(context, 1, single_options(options), threads_),
      whole_(options.is_shared ? std::optional(context.build_whole_graph()) : std::nullopt),
      stepper_(context, step_graph()),
      timed_(single_.graph) {
  if (!is_automatic()) threads_ = single_.executor->threads();
  if (is_automatic() && threads_.total() == 1) reason_ = "serial: one thread";
  if (options.window <= 1 || !reason_.empty()) return;
  const int usual = usual_passes(context.integrator);
  window_ = std::make_unique<Runner>(context, options.window * usual, usual);
  window_->executor = make_asked(window_->graph, options, threads_);
}

StepRunner::~StepRunner() = default;

// The costs are those of the nodes that were timed: a body costs the same in every pass.
std::unique_ptr<graph::Executor> StepRunner::make_planned(const graph::StepGraph& graph) const {
  const std::vector<double> timed = timed_.node_costs();
  const auto key_of = [](const graph::NodeLabel& label) {
    return std::tuple<std::string_view, int, int, std::string_view>(label.stage, label.subsystem,
                                                                    label.body, label.item);
  };
  std::map<decltype(key_of({})), double> cost_of;
  for (int i = 0; i < single_.graph.node_count(); ++i) {
    const graph::NodeLabel& label = single_.graph.node({i}).label;
    cost_of[key_of(label)] = timed[static_cast<std::size_t>(i)];
  }
  std::vector<double> costs;
  costs.reserve(static_cast<std::size_t>(graph.node_count()));
  for (const graph::Node& node : graph.nodes()) costs.push_back(cost_of[key_of(node.label)]);
  return graph::make_auto_executor(graph, threads_.total(),
                                   {std::move(costs), remaining_seconds(), threads_are_worth_});
}

StepOutcome StepRunner::advance_to(std::int64_t target, bool observed,
                                   const TimeStepper::Completed& completed) {
  if (const auto ended = advance_choosing(target, observed, completed)) return *ended;
  if (window_ && options_.window == 0 && window_->executor->settled_on_serial()) {
    reason_ = window_->executor->describe();
    window_.reset();
  }
  return stepper_.advance(target, *runner_for(target - steps()).executor, observed, completed);
}

/// Times steps, and then goes on serially until a window is worth building, or to the target.
/// Returns the outcome if advance_to() ends with it.
std::optional<StepOutcome> StepRunner::advance_choosing(std::int64_t target, bool observed,
                                                        const TimeStepper::Completed& completed) {
  const std::int64_t asked = target - steps();
  while (is_automatic() && !window_ && reason_.empty() && steps() < target) {
    StepOutcome outcome = StepOutcome::done;
    if (!has_timed()) {
      outcome = advance_timed(std::min(target, steps() + kBatch), observed, completed);
    } else if (!probes_ || probes_->pause_left(elapsed_seconds()) <= 0.0) {
      choose_window(asked);
      continue;
    } else {
      const double pause = probes_->pause_left(elapsed_seconds()) / seconds_per_step();
      const double last = static_cast<double>(steps()) + std::ceil(pause) + kBatch;
      const auto stop = static_cast<std::int64_t>(std::min(last, static_cast<double>(target)));
      outcome = stepper_.advance(stop, *single_.executor, observed, completed);
    }
    if (outcome != StepOutcome::done || stepper_.is_stopping()) return outcome;
  }
  return {};
}

StepOutcome StepRunner::open_window(bool observed, const TimeStepper::Completed& completed,
                                    const Between& between) {
  if (!is_automatic() || window_ || !reason_.empty()) return StepOutcome::done;
  while (!has_timed() && steps() < options_.planned_steps) {
    const std::int64_t target = between(std::min(options_.planned_steps, steps() + kBatch));
    const StepOutcome outcome = advance_timed(target, observed, completed);
    if (outcome != StepOutcome::done) return outcome;
  }
  if (steps() >= options_.planned_steps) return StepOutcome::done;  // nothing is left to plan for
  const int passes = window_passes(options_.planned_steps - steps());
  window_ = std::make_unique<Runner>(context_, passes, passes_per_step());
  window_->executor = graph::make_executor(window_->graph, ExecutorKind::serial);
  return StepOutcome::done;
}

StepRunner::Runner& StepRunner::runner_for(std::int64_t steps_asked) {
  // A window much longer than what is asked for would mostly be idle.
  return window_ && 2 * steps_asked >= window_->steps ? *window_ : single_;
}

StepOutcome StepRunner::advance_by(graph::Executor& executor, std::int64_t target, bool observed,
                                   const TimeStepper::Completed& completed,
                                   const Between& between) {
  StepOutcome outcome = StepOutcome::done;
  while (steps() < target && outcome == StepOutcome::done) {
    outcome = stepper_.advance(between(target), executor, observed, completed);
    if (stepper_.is_stopping()) break;
  }
  return outcome;
}

StepOutcome StepRunner::advance_traced(std::int64_t target, bool observed,
                                       const TimeStepper::Completed& completed,
                                       const Between& between, const TraceOptions& options,
                                       StepTrace& trace) {
  trace.asked_steps = target - steps();
  std::int64_t end = between(target);
  Runner& runner = runner_for(end - steps());
  StepRecording recording(runner.graph, context_.table(),
                          {steps() + 1, target, most_passes(context_.integrator),
                           runner.executor->threads().total(), options.buffer_bytes});
  const auto told = [&](std::int64_t step) {
    completed(step);
    if (!options.finished || !recording.is_recorded(step)) return;
    std::vector<NodeSlice> slices;
    const TracedStep traced = recording.collect_step(step, step_size(context_.integrator), slices);
    options.finished(traced, slices);
  };
  const auto collect = [&] {
    recording.end_with(steps());
    recording.collect(step_size(context_.integrator), trace);
    describe_traced(runner, trace);
  };
  StepOutcome outcome = StepOutcome::done;
  try {
    for (;;) {
      {
        const RecordingScope scope(*runner.executor, stepper_, recording, &runner == &single_);
        outcome = stepper_.advance(end, *runner.executor, observed, told);
      }
      if (outcome != StepOutcome::done || stepper_.is_stopping() || steps() >= target) break;
      end = between(target);
    }
  } catch (...) {
    collect();
    throw;
  }
  collect();
  return outcome;
}

/// Describes the executor that really ran the steps, which need not be the one that runs more of
/// them.
void StepRunner::describe_traced(const Runner& runner, StepTrace& trace) const {
  const bool is_window = &runner == window_.get();
  const bool is_tuning = window_ && window_->executor->tuning();
  trace.graph = describe_graph(single_.graph, context_.build_graph(2));
  trace.threads = runner.executor->recorded_threads().total();
  trace.window_steps = runner.steps;
  trace.unused_window = window_ && !is_window ? window_->steps : 0;
  if (is_tuning)
    trace.choice = ChoiceState::tuning;
  else if (is_automatic() && !window_ && reason_.empty())
    trace.choice = ChoiceState::none;
  if (is_window)
    trace.executor = describe_window(is_tuning ? "serial: " : "");
  else if (is_automatic() && !window_ && !stepping_)
    trace.executor = describe();
  else
    trace.executor = single_.executor->describe();
}

StepOutcome StepRunner::advance_one(const TimeStepper::Completed& completed) {
  if (stepping_) return stepper_.advance(steps() + 1, *stepping_->executor, false, completed);
  if (!is_automatic() || threads_.total() == 1 || has_timed())
    return stepper_.advance(steps() + 1, *single_.executor, false, completed);
  const StepOutcome outcome = advance_timed(steps() + 1, false, completed);
  if (outcome == StepOutcome::done && has_timed()) choose_stepping();
  return outcome;
}

bool StepRunner::has_timed() const {
  return timed_steps_ >= 2 * kBatch && timed_steps_ * seconds_per_step() >= kTimingLength;
}

double StepRunner::seconds_per_step() const {
  const double run = graph::median(timed_.run_times()) + timed_.between_runs();
  return run * passes_per_step();
}

double StepRunner::passes_per_step() const {
  return static_cast<double>(timed_.runs()) / timed_steps_;
}

double StepRunner::remaining_seconds() const {
  return static_cast<double>(options_.planned_steps - steps()) * seconds_per_step();
}

StepOutcome StepRunner::advance_timed(std::int64_t target, bool observed,
                                      const TimeStepper::Completed& completed) {
  const auto count = static_cast<int>(target - steps());
  const StepOutcome outcome = stepper_.advance(target, timed_, observed, completed);
  timed_steps_ += count;
  return outcome;
}

void StepRunner::choose_window(std::int64_t steps_asked) {
  const int passes = window_passes(steps_asked);
  const double building = passes * single_.graph.node_count() * kBuildingPerNode;
  if (remaining_seconds() < kLeastPayback * building) {
    std::ostringstream text;
    text.precision(2);
    text << "serial: what is left takes " << remaining_seconds() << " s, too short to plan for";
    reason_ = text.str();
    return;
  }
  if (!is_worth_building(building)) return;
  window_ = std::make_unique<Runner>(context_, passes, passes_per_step());
  window_->executor = make_planned(window_->graph);
}

/// The machine is asked whether it has another processor at present before building takes more than
/// tuning may cost.
bool StepRunner::is_worth_building(double seconds) {
  const int processors = std::min(threads_.total(), graph::available_threads());
  if (processors == 1 || seconds < graph::kTuningShare * remaining_seconds()) return true;
  if (!probes_) probes_.emplace(processors, elapsed_seconds() + remaining_seconds());
  threads_are_worth_ = probes_->find_worth(elapsed_seconds());
  return threads_are_worth_;
}

// A window of n passes costs n times the building of one pass's graph, once, and the remaining
// simulation so many times the overhead of a run as there are windows in it: the sum is least where
// both are equal.
int StepRunner::window_passes(std::int64_t steps_asked) const {
  if (options_.window == 1) return 1;
  const double per_step = passes_per_step();
  const double pass = seconds_per_step() / per_step;
  const double passes_left = remaining_seconds() / pass;
  const double building = single_.graph.node_count() * kBuildingPerNode;
  const double best = std::sqrt(passes_left * kRunOverhead / building);
  const double records = static_cast<double>(context_.table().ring_size()) / 2.0;
  const double most = std::min({static_cast<double>(kMostNodes) / single_.graph.node_count(),
                                std::ceil(kLongestRun / pass), records * per_step,
                                static_cast<double>(steps_asked) * per_step});
  return static_cast<int>(std::clamp(std::ceil(best), 1.0, std::max(most, 1.0)));
}

void StepRunner::choose_stepping() {
  if (seconds_per_step() < kLongStep) return;
  const double building = single_.graph.node_count() * kBuildingPerNode;
  if (remaining_seconds() < kLeastPayback * building) return;
  stepping_ = std::make_unique<Runner>(context_, 1, passes_per_step());
  stepping_->executor = make_planned(stepping_->graph);
}

std::string_view StepRunner::executor_name() const {
  return is_automatic() ? name_of(ExecutorKind::automatic) : single_.executor->name();
}

int StepRunner::choices() const {
  if (window_) return window_->executor->choices() + (probes_ ? 1 : 0);
  if (stepping_) return stepping_->executor->choices();
  if (!is_automatic()) return single_.executor->choices();
  return reason_.empty() && !probes_ ? 0 : 1;
}

std::string StepRunner::describe_window(const std::string& before) const {
  std::string how = before + window_->executor->describe();
  if (window_->steps == 1) return how;
  return "windows of " + std::to_string(window_->steps) + " steps, " + how;
}

std::string StepRunner::describe() const {
  if (window_) return describe_window("");
  if (stepping_) return stepping_->executor->describe();
  if (!is_automatic()) return single_.executor->describe();
  if (!reason_.empty()) return reason_;
  return probes_ ? "serial: " + probes_->describe() : "serial: not timed yet";
}

}  // namespace spoke
