#pragma once

// Recording of steps: the step and pass of each recorded run of a node.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/step/run/time_stepper.h"
#include "engine/step_trace.h"
#include "graph/execute/node_recorder.h"

namespace spoke {

/// The extent of a recording.
struct RecordingPlan {
  std::int64_t first_step = 1;
  std::int64_t last_step = 1;
  int most_passes = 1;           ///< the most that a step can take
  int threads = 1;               ///< threads of the executor
  std::size_t buffer_bytes = 0;  ///< most memory
};

/// Records the runs of an executor and, between them, to which step and pass each pass of a run
/// belongs: its nodes only know which pass of the run it is, for each subsystem makes progress of
/// its own. All memory is allocated in the constructor: room for as many runs as the steps can
/// take, or for those that fit.
class StepRecording final : public RunWatch {
 public:
  /// Records runs of `run_graph`, the graph that the executor runs, of any number of passes on
  /// `data`; it must outlive this.
  StepRecording(const graph::StepGraph& run_graph, const StepTable& data,
                const RecordingPlan& plan);

  /// Returns the recorder for Executor::set_recorder().
  graph::NodeRecorder& recorder() { return recorder_; }

  void begin_run(const StepTable& data) override;
  void end_run(const StepTable& data) override;

  /// Returns a step that is complete and not dropped, between two runs; its slices are added to
  /// `slices`, by begin.
  TracedStep collect_step(std::int64_t step, double step_size,
                          std::vector<NodeSlice>& slices) const;
  /// Whether all runs that made the step were recorded.
  bool is_recorded(std::int64_t step) const {
    return is_wanted(step) && step <= complete_ && !is_dropped(step);
  }
  /// Ends the recording: steps beyond `step` were not made, or were undone.
  void end_with(std::int64_t step) { complete_ = std::min(complete_, step); }

  /// Adds steps, slices, runs, the dropped ones, and the room that would have sufficed.
  void collect(double step_size, StepTrace& trace) const;

 private:
  /// The step and pass that a subsystem, or a coupled system, made in a pass of a run.
  struct PassOfStep {
    std::int64_t step = -1;
    int pass = -1;
  };
  /// Origin of a node of the run graph.
  struct Origin {
    int node = 0;       ///< number in the graph of one pass
    int progress = -1;  ///< index of the progress that it follows; -1: none
    int pass = 0;       ///< pass of the run
  };

  /// Memory that a recording needs [bytes].
  struct Needs {
    std::size_t always = 0;   ///< whatever is recorded
    std::size_t run = 0;      ///< times of a run, and its passes of steps
    std::size_t records = 0;  ///< records of a run, if one thread runs all of its nodes
  };

  static int count_passes(const graph::StepGraph& run_graph);
  Needs find_needs() const;
  std::size_t count_most_runs() const;
  graph::RecorderRoom find_room() const;
  int count_runs() const { return recorder_.runs() + recorder_.dropped_runs(); }
  std::size_t bytes_of(int runs) const;
  void find_origins(const graph::StepGraph& run_graph, bool is_coupled);
  void find_passes(const StepTable& data);
  PassOfStep pass_of_all(const StepTable& data) const;
  void keep_passes(const StepTable& data);
  void drop_steps();
  bool is_wanted(std::int64_t step) const {
    return step >= plan_.first_step && step <= plan_.last_step;
  }
  bool is_dropped(std::int64_t step) const {
    return dropped_[static_cast<std::size_t>(step - plan_.first_step)] != 0;
  }
  std::int64_t count_dropped() const;
  /// Adds those slices of a run that `wants(at)`.
  template <class Wants>
  void add_slices(int run, Wants wants, std::vector<NodeSlice>& slices) const;
  std::span<const PassOfStep> passes_in(int run) const {
    return std::span(all_passes_)
        .subspan(static_cast<std::size_t>(run) * run_passes_.size(), run_passes_.size());
  }
  PassOfStep pass_of(const Origin& origin, int run) const;
  std::vector<TracedStep> find_steps(double step_size) const;

  RecordingPlan plan_;
  int passes_;          ///< passes of a run
  int progress_count_;  ///< progresses of the table
  int nodes_;           ///< nodes of the run graph
  graph::RecorderRoom room_;
  graph::NodeRecorder recorder_;
  std::vector<Origin> origins_;  ///< by node of the run graph
  std::vector<PassOfStep>
      at_begin_;  ///< by index of progress, at the begin of the run that goes on
  std::vector<PassOfStep> run_passes_;  ///< by index of progress and pass, in that run
  std::vector<PassOfStep> all_passes_;  ///< run_passes_ of all recorded runs
  std::vector<PassOfStep>
      system_passes_;          ///< by recorded run, for the node that follows no progress
  std::vector<char> dropped_;  ///< by step
  std::int64_t complete_ = 0;  ///< steps when a run began or ended last
  int runs_of_first_ = 0;      ///< runs that made the first step
};

/// Describes the graph of one pass as data. `two_passes` has the edges to the next pass.
TracedGraph describe_graph(const graph::StepGraph& one_pass, const graph::StepGraph& two_passes);

}  // namespace spoke
