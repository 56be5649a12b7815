#pragma once

// Advances a system by steps and windows of steps, with a given executor.

#include <cstdint>
#include <functional>

#include "engine/bodies/table/state_copy.h"
#include "engine/step/step_context.h"
#include "graph/executor.h"

namespace spoke {

/// Whether all subsystems stand at the beginning of one step, and none has failed.
bool are_together(const StepTable& data);
/// Notified, on the calling thread, before a run of the step graph, when its window is set, and
/// after it, before its steps are reported.
class RunWatch {
 public:
  RunWatch() = default;
  RunWatch(const RunWatch&) = delete;
  RunWatch& operator=(const RunWatch&) = delete;
  virtual void begin_run(const StepTable& data) = 0;
  virtual void end_run(const StepTable& data) = 0;

 protected:
  ~RunWatch() = default;
};

/// Advances a system by runs of its step graph. A run makes as many passes as the graph has, and
/// each subsystem as many steps in them as it can, up to the end of a window: as many steps beyond
/// the last complete one as the table has records for. Subsystems with progress of their own may
/// stand at different steps between two runs; they meet again at the target of advance().
///
/// Where subsystems are shared out over processes, all of these call the same functions. They meet
/// at the end of each window, which is the same for all however their graphs and executors differ;
/// behind advance() each has the whole state. Passes made serially between steps, or again behind a
/// failure, are made by each of the whole system.
class TimeStepper {
 public:
  /// Called with each complete step, in order, while its records (and samples, if they are
  /// observed) are in the table.
  using Completed = std::function<void(std::int64_t step)>;

  /// `graph` is that of one pass over all subsystems, on `context`. Both must outlive the stepper.
  TimeStepper(StepContext& context, const graph::StepGraph& graph);

  /// Evaluates the accelerations at t = 0, serially, and finds those to start from.
  StepOutcome start();
  /// Advances to the end of step `target`, by runs of `executor`, whose graph is one of any number
  /// of passes on the context. `observed`: samples are taken at each step. `completed` may be
  /// empty; an exception of it leaves the system at the end of the step that it was called with. If
  /// a step fails, the system stands at that step as if it had been advanced step by step, whatever
  /// the window and the executor; if a load of the user's fails, at the end of the step before, and
  /// can be advanced again.
  StepOutcome advance(std::int64_t target, graph::Executor& executor, bool observed = false,
                      const Completed& completed = {});

  /// Ends advance(), called by `completed` while it runs, at the last step that any subsystem has
  /// begun; shared subsystems end at the end of the window after this, in all processes.
  void stop() { is_asked_to_stop_ = true; }
  /// Whether stop() has ended the last advance().
  bool is_stopping() const { return is_stopping_; }
  /// Goes on from a state that was put into the table, taken at the end of step `steps`; also after
  /// a failed step, or an exception of `completed`. The power at the end of that step stays known.
  void continue_from(std::int64_t steps);
  /// Evaluates accelerations, wrenches and frames at the state at the end of the last step, which
  /// stays as it is but for `renew`: forces have changed since, and the next step starts from
  /// accelerations that know of it. The record that the step would have is left in the table
  /// (StepTable::take_evaluated_record). Precondition: are_together().
  StepOutcome evaluate(bool renew);
  /// Lets `watch` follow all runs by executors until it is replaced; nullptr: none does.
  /// `together`: meanwhile no subsystem begins a step before all have completed the one before. Not
  /// during advance().
  void watch_runs(RunWatch* watch, bool together = false) {
    watch_ = watch;
    stays_together_ = together;
  }

  /// Returns how many steps are complete; those that failed are not.
  std::int64_t steps() const { return steps_; }

 private:
  struct Advance;

  void open_window(Advance& advance);
  bool continues(Advance& advance);
  bool end_window();
  void share_state();
  bool is_implicit() const;
  StepOutcome run_between_steps(int stage);
  StepOutcome evaluate_once();
  StepOutcome restart();
  void report_steps(Advance& advance);
  StepOutcome repeat_failure(Advance& advance);
  StepOutcome end_failed();
  void keep_good_state();
  void run_serially();
  void run_step_serially(std::int64_t step);
  void return_to_last_step();

  StepContext& context_;
  const graph::StepGraph& graph_;
  std::int64_t steps_ = -1;
  StateCopy saved_;  ///< a state from which a failure can be repeated
  std::int64_t saved_steps_ = -1;
  std::vector<double> good_;  ///< the state at the end of step good_steps_, if there are loads
  std::int64_t good_steps_ = -1;
  bool is_whole_ = true;  ///< whether the table has the state of other processes' subsystems, too
  bool is_asked_to_stop_ = false, is_stopping_ = false;
  RunWatch* watch_ = nullptr;
  bool stays_together_ = false;
};

}  // namespace spoke
