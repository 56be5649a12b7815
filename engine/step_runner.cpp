#include "engine/step_runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "engine/step_graph_builder.h"
#include "engine/step_recording.h"

namespace spoke {
namespace {

using graph::ExecutorKind;

// Planning takes some 100 ms; a run shorter than this would not win that back.
constexpr double kWorthPlanning = 0.4;  // s
// A window's run: long against the microseconds that handing work to threads takes.
constexpr double kRunLength = 600e-6;  // s
// A graph is built in about 2 us a node, and searched for plans in about 10.
constexpr int kMostNodes = 12000;
// Below this, a step by itself is no longer than handing its parts to threads.
constexpr double kLongStep = 40e-6;  // s

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

/// While it lives, a recording follows an executor and a stepper.
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

ExecutorKind single_kind(ExecutorKind kind) {
  return kind == ExecutorKind::automatic ? ExecutorKind::serial : kind;
}

}  // namespace

int window_records(const RunnerOptions& options, const System& system) {
  // Twice as many records as steps: a subsystem that is ahead need not wait for the others.
  if (options.window > 0) return options.window > 1 ? 2 * options.window : 1;
  if (options.executor != ExecutorKind::automatic || resolved(options.threads).total() == 1)
    return 1;
  constexpr double most_bytes = 4e6;
  const double bytes = sizeof(SystemRecord) + static_cast<double>(system.subsystems.size()) *
                                                  (sizeof(StepRecord) + sizeof(SubsystemSample));
  return static_cast<int>(std::clamp(most_bytes / bytes, 4.0, 1024.0));
}

StepRunner::Runner::Runner(StepContext& context, int passes, ExecutorKind kind,
                           graph::Threads threads)
    : graph(build_step_graph(context, passes)),
      executor(graph::make_executor(graph, kind, threads)) {}

StepRunner::StepRunner(StepContext& context, const RunnerOptions& options)
    : context_(context),
      options_(options),
      threads_(allowed_threads(options)),
      single_(context, 1, single_kind(options.executor), threads_),
      stepper_(context, single_.graph) {
  if (!is_automatic()) threads_ = single_.executor->threads();
  if (is_automatic() && threads_.total() == 1) reason_ = "serial: one thread";
  if (options.window > 1 && reason_.empty())
    add_window(options.window * usual_passes(context.integrator));
}

StepRunner::~StepRunner() = default;

void StepRunner::add_window(int passes) {
  window_ = std::make_unique<Runner>(context_, passes, options_.executor, threads_);
  window_->steps = std::max(1, passes / usual_passes(context_.integrator));
}

StepOutcome StepRunner::advance_to(std::int64_t target, bool observed,
                                   const TimeStepper::Completed& completed) {
  const std::int64_t asked = target - steps();
  while (is_automatic() && !window_ && reason_.empty() && steps() < target) {
    if (has_timed()) {
      choose_window(asked);
      break;
    }
    const StepOutcome outcome =
        advance_timed(std::min(target, steps() + kBatch), observed, completed);
    if (outcome != StepOutcome::done || stepper_.is_stopping()) return outcome;
  }
  if (window_ && options_.window == 0 && window_->executor->settled_on_serial()) {
    reason_ = window_->executor->describe();
    window_.reset();  // a graph of one pass stays in cache
  }
  return stepper_.advance(target, *runner_for(target - steps()).executor, observed, completed);
}

StepOutcome StepRunner::open_window(bool observed, const TimeStepper::Completed& completed) {
  if (!is_automatic() || window_ || !reason_.empty()) return StepOutcome::done;
  while (!has_timed() && steps() < options_.planned_steps) {
    const std::int64_t target = std::min(options_.planned_steps, steps() + kBatch);
    const StepOutcome outcome = advance_timed(target, observed, completed);
    if (outcome != StepOutcome::done) return outcome;
  }
  add_window(window_passes(options_.planned_steps - steps()));
  return StepOutcome::done;
}

StepRunner::Runner& StepRunner::runner_for(std::int64_t steps_asked) {
  // A window much longer than what is asked for would mostly be idle.
  return window_ && 2 * steps_asked >= window_->steps ? *window_ : single_;
}

StepOutcome StepRunner::advance_traced(std::int64_t target, bool observed,
                                       const TimeStepper::Completed& completed,
                                       const TraceOptions& options, StepTrace& trace) {
  trace.asked_steps = target - steps();
  Runner& runner = runner_for(trace.asked_steps);
  StepRecording recording(runner.graph, context_.data,
                          {steps() + 1, target, most_passes(context_.integrator),
                           runner.executor->threads().total(), options.buffer_bytes});
  const RecordingScope scope(*runner.executor, stepper_, recording, &runner == &single_);
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
    outcome = stepper_.advance(target, *runner.executor, observed, told);
  } catch (...) {
    collect();
    throw;
  }
  collect();
  return outcome;
}

/// What really ran the steps, which need not be what runs more of them.
void StepRunner::describe_traced(const Runner& runner, StepTrace& trace) const {
  const bool is_window = &runner == window_.get();
  const bool is_tuning = window_ && window_->executor->tuning();
  trace.graph = describe_graph(single_.graph, build_step_graph(context_, 2));
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
  return timed_steps_ >= 2 * kBatch && seconds_ >= kTimingLength;
}

double StepRunner::remaining_seconds() const {
  return static_cast<double>(options_.planned_steps - steps()) * fastest_;
}

StepOutcome StepRunner::advance_timed(std::int64_t target, bool observed,
                                      const TimeStepper::Completed& completed) {
  using Timer = std::chrono::steady_clock;
  const auto count = static_cast<int>(target - steps());
  const auto begin = Timer::now();
  const StepOutcome outcome = stepper_.advance(target, *single_.executor, observed, completed);
  const double seconds = std::chrono::duration<double>(Timer::now() - begin).count();
  seconds_ += seconds;
  fastest_ = timed_steps_ == 0 ? seconds / count : std::min(fastest_, seconds / count);
  timed_steps_ += count;
  return outcome;
}

void StepRunner::choose_window(std::int64_t steps_asked) {
  if (remaining_seconds() < kWorthPlanning) {
    std::ostringstream text;
    text.precision(2);
    text << "serial: what is left takes " << remaining_seconds() << " s, too short to plan for";
    reason_ = text.str();
    return;
  }
  add_window(window_passes(steps_asked));
}

int StepRunner::window_passes(std::int64_t steps_asked) const {
  const int usual = usual_passes(context_.integrator);
  const double pass = fastest_ / usual;
  const int affordable = std::max(1, kMostNodes / single_.graph.node_count());
  const double records = static_cast<double>(context_.data.records.size()) / 2.0;
  const double most = std::min(
      {static_cast<double>(affordable), records * usual, static_cast<double>(steps_asked) * usual});
  return static_cast<int>(std::clamp(std::ceil(kRunLength / pass), 1.0, std::max(most, 1.0)));
}

void StepRunner::choose_stepping() {
  if (remaining_seconds() < kWorthPlanning || fastest_ < kLongStep) return;
  stepping_ = std::make_unique<Runner>(context_, 1, ExecutorKind::automatic, threads_);
}

int StepRunner::choices() const {
  if (!is_automatic()) return 0;
  if (window_) return window_->executor->choices();
  if (stepping_) return stepping_->executor->choices();
  return reason_.empty() ? 0 : 1;
}

std::string StepRunner::describe_window(const std::string& before) const {
  const std::string how = before + window_->executor->describe();
  if (window_->steps == 1) return how;
  return "windows of " + std::to_string(window_->steps) + " steps, " + how;
}

std::string StepRunner::describe() const {
  if (window_) return describe_window("");
  if (stepping_) return stepping_->executor->describe();
  if (!is_automatic()) return single_.executor->describe();
  return reason_.empty() ? "serial: not timed yet" : reason_;
}

}  // namespace spoke
