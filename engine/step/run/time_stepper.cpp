// Opens a window, runs the graph until its steps are complete, and goes back where a step has
// failed.

#include "engine/step/run/time_stepper.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <span>

#include "engine/bodies/table/state_values.h"
#include "engine/step/pass_integration.h"

namespace spoke {
namespace {

/// Steps between two copies of the state: a compromise between the cost of repeating a failure and
/// that of copies.
constexpr std::int64_t kStepsPerCopy = 256;

bool is_any_failed(const StepTable& data) {
  return std::any_of(data.progress.begin(), data.progress.end(), [](const StepProgress& progress) {
    return progress.outcome != StepOutcome::done;
  });
}

bool are_all_halted(std::span<const StepProgress> all) {
  return std::all_of(all.begin(), all.end(),
                     [](const StepProgress& progress) { return progress.is_halted; });
}

StepOutcome first_failure(const StepTable& data) {
  for (const StepProgress& progress : data.progress)
    if (progress.outcome != StepOutcome::done) return progress.outcome;
  return StepOutcome::done;
}

/// Returns the last step that any subsystem has begun.
std::int64_t furthest_step(const StepTable& data) {
  std::int64_t furthest = 0;
  for (const StepProgress& progress : data.progress)
    furthest = std::max(furthest, progress.passes > 0 ? progress.step : progress.step - 1);
  return furthest;
}

/// Lets all subsystems go to the end of step `last`.
void let_go(std::int64_t last, StepTable& data) {
  data.window.last = last;
  for (StepProgress& progress : data.progress)
    if (progress.outcome == StepOutcome::done) progress.is_halted = progress.step > last;
}

}  // namespace

bool are_together(const StepTable& data) {
  const std::int64_t step = data.progress[0].step;
  return std::all_of(data.progress.begin(), data.progress.end(),
                     [step](const StepProgress& progress) {
                       return progress.step == step && progress.passes == 0 &&
                              progress.outcome == StepOutcome::done;
                     });
}

/// State of one call of advance().
struct TimeStepper::Advance {
  std::int64_t target;
  const Completed& completed;
  bool is_wide;                ///< subsystems may stand at different steps
  std::int64_t next_copy = 0;  ///< step of the next copy
  std::exception_ptr thrown;   ///< exception of `completed`; none may cross an executor
};

TimeStepper::TimeStepper(StepContext& context, const graph::StepGraph& graph)
    : context_(context), graph_(graph), saved_(context.table()) {}

void TimeStepper::run_serially() {
  for (const graph::NodeId node : graph_.serial_order()) graph_.run_node(node);
}

bool TimeStepper::is_implicit() const {
  return std::holds_alternative<GeneralizedAlpha>(context_.integrator.method);
}

/// Runs one pass at the end of step steps_, serially.
StepOutcome TimeStepper::run_between_steps(int stage) {
  StepTable& data = context_.table();
  data.window = {steps_, steps_, false};
  for (StepProgress& progress : data.progress) {
    const IterationMemory remembered = progress.remembered;
    progress = make_progress_between_steps(context_.integrator, steps_, stage);
    progress.remembered = remembered;
  }
  run_serially();
  return data.is_any_load_failed() ? StepOutcome::load_failed : first_failure(data);
}

/// Evaluates the true accelerations at the end of step steps_.
StepOutcome TimeStepper::evaluate_once() {
  if (is_implicit()) context_.table().for_each_block(hold);
  return run_between_steps(PassControl::kEvaluateOnly);
}

/// Finds the accelerations that the next step starts from, where forces may have jumped.
StepOutcome TimeStepper::restart() {
  const auto& alpha = std::get<GeneralizedAlpha>(context_.integrator.method);
  context_.table().for_each_block([&](CoordinateBlock& block) { begin_restart(alpha, block); });
  return run_between_steps(PassControl::kRestart);
}

StepOutcome TimeStepper::start() {
  StepTable& data = context_.table();
  steps_ = 0;
  const StepOutcome outcome = evaluate_once();
  if (outcome != StepOutcome::done || !is_implicit()) return outcome;
  data.keep_record(0);
  data.for_each_block(clear_accelerations);
  const StepOutcome started = restart();
  data.return_record(0);
  if (started == StepOutcome::done) continue_from(0);
  return started;
}

void TimeStepper::continue_from(std::int64_t steps) {
  assert(steps >= 0);
  for (StepProgress& progress : context_.table().progress) {
    const Power power = progress.power;
    const IterationMemory remembered = progress.remembered;
    progress = StepProgress{};
    progress.power = power;
    progress.remembered = remembered;
    progress.completed = steps;
    progress.is_halted = true;
    begin_step(context_.integrator, steps + 1, progress);
  }
  steps_ = steps;
  good_steps_ = -1;
}

StepOutcome TimeStepper::evaluate(bool renew) {
  StepTable& data = context_.table();
  assert(are_together(data));
  const std::vector<double> before = take_state_values(steps_, data);
  data.keep_record(steps_);
  data.clear_load_failures();
  StepOutcome outcome = evaluate_once();
  data.take_evaluated_record(steps_);
  const bool is_renewed = renew && outcome == StepOutcome::done;
  if (!is_renewed || is_implicit()) data.put_state(before, steps_);
  if (is_renewed && is_implicit()) outcome = restart();
  if (outcome != StepOutcome::done) data.put_state(before, steps_);
  data.return_record(steps_);
  continue_from(steps_);
  return outcome;
}

StepOutcome TimeStepper::advance(std::int64_t target, graph::Executor& executor, bool observed,
                                 const Completed& completed) {
  StepTable& data = context_.table();
  is_stopping_ = is_asked_to_stop_ = false;
  if (steps_ >= target) return StepOutcome::done;
  data.clear_load_failures();
  const bool is_wide =
      context_.sharing || (data.ring_size() > 1 && target > steps_ + 1 && !stays_together_);
  Advance advance{target, completed, is_wide, steps_, nullptr};
  data.window.observed = observed;
  open_window(advance);
  if (watch_) watch_->begin_run(data);
  executor.run_while([this, &advance] { return continues(advance); });
  if (advance.thrown) {
    if (advance.is_wide) return_to_last_step();
    std::rethrow_exception(advance.thrown);
  }
  if (!is_any_failed(data)) {
    share_state();
    return StepOutcome::done;
  }
  return advance.is_wide ? repeat_failure(advance) : end_failed();
}

/// Ends with a failed step. If a load has failed, the system goes back to the end of the step
/// before.
StepOutcome TimeStepper::end_failed() {
  StepTable& data = context_.table();
  if (!data.is_any_load_failed()) return first_failure(data);
  data.put_state(good_, steps_);
  continue_from(steps_);
  return StepOutcome::load_failed;
}

/// Keeps a state to go back to, in systems with loads.
void TimeStepper::keep_good_state() {
  StepTable& data = context_.table();
  if (good_steps_ == steps_ || !data.has_loads() || !are_together(data)) return;
  data.take_state(steps_, good_);
  good_steps_ = steps_;
}

void TimeStepper::open_window(Advance& advance) {
  StepTable& data = context_.table();
  std::int64_t last = std::min(
      advance.target, steps_ + (advance.is_wide ? static_cast<std::int64_t>(data.ring_size()) : 1));
  if (advance.is_wide && steps_ >= advance.next_copy) {
    if (are_together(data)) {
      share_state();
      saved_.save();
      saved_steps_ = steps_;
      advance.next_copy = steps_ + kStepsPerCopy;
    } else {
      last = furthest_step(data);  // wait for one another
    }
  }
  if (!advance.is_wide) keep_good_state();
  data.window.first = steps_ + 1;
  let_go(last, data);
}

/// Whether the own subsystems, where they are shared out, have come to the end of the window. All
/// processes then know of all.
bool TimeStepper::end_window() {
  if (!are_all_halted(context_.own_progress())) return false;
  is_stopping_ = context_.share_window(is_asked_to_stop_);
  is_whole_ = false;
  return true;
}

/// Takes the state of subsystems that other processes have.
void TimeStepper::share_state() {
  if (!is_whole_) context_.sharing->state.share();
  is_whole_ = true;
}

/// Reports, after a run, its steps and sets the next one, if there is one to be made.
bool TimeStepper::continues(Advance& advance) {
  StepTable& data = context_.table();
  if (context_.sharing && !end_window()) return true;
  if (watch_) watch_->end_run(data);
  report_steps(advance);
  if (!context_.sharing) is_stopping_ = is_asked_to_stop_;
  if (is_stopping_)
    advance.target = std::min(advance.target, std::max(steps_, furthest_step(data)));
  if (advance.thrown || steps_ >= advance.target) return false;
  if (is_any_failed(data)) {
    // Where subsystems do not part, the others complete the step; where they do, it will be
    // repeated.
    if (advance.is_wide || are_all_halted(data.progress)) return false;
  } else {
    open_window(advance);
  }
  if (watch_) watch_->begin_run(data);
  return true;
}

void TimeStepper::report_steps(Advance& advance) {
  const std::int64_t last = last_complete_step(context_.table());
  while (steps_ < last && !advance.thrown) {
    ++steps_;
    if (!advance.completed) continue;
    try {
      advance.completed(steps_);
    } catch (...) {
      advance.thrown = std::current_exception();
    }
  }
}

void TimeStepper::run_step_serially(std::int64_t step) {
  StepTable& data = context_.table();
  data.window.first = step;
  let_go(step, data);
  while (!are_all_halted(data.progress)) run_serially();
}

/// Goes back to the last copy and steps, one step at a time, to the end of the step that was
/// reported last: some subsystems were beyond it.
void TimeStepper::return_to_last_step() {
  saved_.restore();
  is_whole_ = true;
  context_.table().clear_load_failures();
  good_steps_ = -1;
  for (std::int64_t step = saved_steps_ + 1; step <= steps_; ++step) run_step_serially(step);
}

/// Goes back to the last copy and steps, one step at a time, into the failure again; or to the
/// target, if it was the failure of a load that does not fail again.
StepOutcome TimeStepper::repeat_failure(Advance& advance) {
  StepTable& data = context_.table();
  saved_.restore();
  is_whole_ = true;
  data.clear_load_failures();
  good_steps_ = -1;
  for (std::int64_t step = saved_steps_ + 1; step <= advance.target; ++step) {
    if (step == steps_ + 1) keep_good_state();
    run_step_serially(step);
    report_steps(advance);
    if (advance.thrown) std::rethrow_exception(advance.thrown);
    if (is_any_failed(data)) return end_failed();
  }
  return StepOutcome::done;
}

}  // namespace spoke
