#pragma once

// The choice of step graph and executor that run the steps.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/step/run/time_stepper.h"
#include "engine/step/step_context.h"
#include "engine/step_trace.h"
#include "graph/calibrate/measuring_executor.h"
#include "graph/executor.h"
#include "graph/tune/capacity_probes.h"

namespace spoke {

/// Options of the runs of steps.
struct RunnerOptions {
  graph::ExecutorKind executor = graph::ExecutorKind::automatic;
  graph::Threads threads;          ///< unset: the available ones
  int window = 0;                  ///< steps; 0: as the executor chooses
  std::int64_t planned_steps = 0;  ///< steps of the simulation
  /// Makes an executor of the caller's own, instead of `executor`, which is then not automatic; or
  /// empty.
  graph::ExecutorFactory make_executor{};
  /// Whether other processes have subsystems, too: their actions at the same times must not depend
  /// on times that one of them measures. The executor `automatic` then chooses how a graph is run,
  /// not which.
  bool is_shared = false;
};

/// Returns the records that the table of a system needs for these options, see
/// TableOptions::window_steps. `bytes_per_step`: bytes of one step in the rings.
int window_records(const RunnerOptions& options, double bytes_per_step);

/// Step graphs of a context, and the executors that run them: one graph of a single pass, and, if
/// it pays, one of the passes of a window of steps.
///
/// The executor `automatic` begins with some serial steps whose nodes it times. If the remaining
/// simulation takes long enough to win back the building, and the machine has another processor at
/// present, it makes the graph of a window, the longer the more is left, and hands it with the
/// nodes' costs to graph::make_auto_executor(), which goes parallel at once. Callers of
/// advance_one() get no window; then long steps only are planned.
class StepRunner {
 public:
  /// Lets what acts between steps act where the system stands, and returns the step, at most
  /// `target`, up to which nothing else does.
  using Between = std::function<std::int64_t(std::int64_t target)>;

  /// `context` must be allocated with window_records() and outlive this.
  StepRunner(StepContext& context, const RunnerOptions& options);
  ~StepRunner();

  /// Calls TimeStepper::start().
  StepOutcome start() { return stepper_.start(); }
  StepOutcome advance_to(std::int64_t target, bool observed,
                         const TimeStepper::Completed& completed);
  StepOutcome advance_one(const TimeStepper::Completed& completed);
  /// Prepares the executor `automatic` on several threads without a window: makes the steps that it
  /// times first, and builds the graph of the window that it would choose for a simulation that is
  /// worth planning for; none if no step is left then. Plans nothing.
  StepOutcome open_window(bool observed, const TimeStepper::Completed& completed,
                          const Between& between);
  /// Advances by an executor of the caller's that runs run_graph().
  StepOutcome advance_by(graph::Executor& executor, std::int64_t target, bool observed,
                         const TimeStepper::Completed& completed, const Between& between);
  /// Advances like advance_to(), by the present graph and executor; nothing is chosen meanwhile.
  /// The work of each thread is recorded, but for what is evaluated between steps; also of steps
  /// before one that fails or an exception.
  StepOutcome advance_traced(std::int64_t target, bool observed,
                             const TimeStepper::Completed& completed, const Between& between,
                             const TraceOptions& options, StepTrace& trace);
  std::int64_t steps() const { return stepper_.steps(); }
  /// Calls TimeStepper::stop(), while advance_to() runs.
  void stop() { stepper_.stop(); }
  /// Whether stop() has ended the last advance_to().
  bool is_stopping() const { return stepper_.is_stopping(); }
  StepOutcome evaluate(bool renew) { return stepper_.evaluate(renew); }
  void continue_from(std::int64_t steps) { stepper_.continue_from(steps); }

  /// Returns the graph of one pass over all subsystems.
  const graph::StepGraph& step_graph() const { return whole_ ? *whole_ : single_.graph; }
  /// Returns the graph of a window, if there is one, else of one pass.
  const graph::StepGraph& run_graph() const { return window_ ? window_->graph : single_.graph; }
  /// Returns about how many steps a run of run_graph() makes.
  int run_steps() const { return window_ ? window_->steps : 1; }
  graph::Threads threads() const { return threads_; }
  /// Returns the executor's name: "auto", "serial", ..., or the name of the caller's own.
  std::string_view executor_name() const;
  /// Returns how many times `automatic` has chosen; 0 for the others.
  int choices() const;
  /// Describes in one line the runner of the steps, and if it was chosen, why.
  std::string describe() const;

 private:
  /// A graph and its executor.
  struct Runner {
    Runner(StepContext& context, int passes, const RunnerOptions& options, graph::Threads threads);
    /// Builds the graph alone.
    Runner(StepContext& context, int passes, double passes_per_step);
    graph::StepGraph graph;
    std::unique_ptr<graph::Executor> executor;
    int steps = 1;  ///< about how many a run makes
  };

  Runner& runner_for(std::int64_t steps);
  /// Whether steps are timed to choose graphs.
  bool is_automatic() const {
    return options_.executor == graph::ExecutorKind::automatic && !options_.is_shared;
  }
  bool has_timed() const;
  double elapsed_seconds() const { return static_cast<double>(steps()) * seconds_per_step(); }
  double remaining_seconds() const;
  StepOutcome advance_timed(std::int64_t target, bool observed,
                            const TimeStepper::Completed& completed);
  void choose_window(std::int64_t steps);
  bool is_worth_building(double seconds);
  std::optional<StepOutcome> advance_choosing(std::int64_t target, bool observed,
                                              const TimeStepper::Completed& completed);
  int window_passes(std::int64_t steps) const;
  void choose_stepping();
  std::unique_ptr<graph::Executor> make_planned(const graph::StepGraph& graph) const;
  /// Returns the mean duration of the steps that were timed [s].
  double seconds_per_step() const;
  double passes_per_step() const;
  void describe_traced(const Runner& runner, StepTrace& trace) const;
  std::string describe_window(const std::string& before) const;

  StepContext& context_;
  RunnerOptions options_;
  graph::Threads threads_;
  Runner single_;
  std::optional<graph::StepGraph> whole_;  ///< where single_ has the nodes of some subsystems only
  std::unique_ptr<Runner> window_;
  std::unique_ptr<Runner> stepping_;  ///< runs steps one by one for the executor automatic
  TimeStepper stepper_;
  graph::MeasuringExecutor timed_;  ///< runs the first steps of the executor automatic
  int timed_steps_ = 0;
  std::string reason_;                           ///< why there is no window
  std::optional<graph::CapacityProbes> probes_;  ///< before a window is built
  bool threads_are_worth_ = false;  ///< whether threads are worth it, by the last probe
};

}  // namespace spoke
