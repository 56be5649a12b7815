#pragma once

// Records of steps, node by node, made by Simulation::trace().

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "graph/step_graph.h"
#include "spoke/export.h"

namespace spoke {

/// One run of a node. Times are whole nanoseconds from the start of the recording; on a thread a
/// slice begins where the one before it ends, or later.
struct NodeSlice {
  int node = -1;           ///< index in the graph of one pass
  std::int64_t step = -1;  ///< its number; -1: a surplus pass, in which the node had nothing to do
  int pass = -1;           ///< within the step, from 0; -1: a surplus pass
  int cluster = -1;        ///< of the executor's plan; -1: it has none
  int thread = 0;          ///< of the executor; 0: the one that called it
  std::int64_t begin = 0;  ///< [ns]
  std::int64_t end = 0;    ///< [ns]
};

/// A step that was recorded.
struct TracedStep {
  std::int64_t step = 0;  ///< its number
  double time = 0.0;      ///< at its end [s]
  int passes = 0;         ///< number of passes of the subsystem that needed most
};

/// A run of the executor: from before its first node to after its last.
struct TracedRun {
  std::int64_t begin = 0;  ///< [ns]
  std::int64_t end = 0;    ///< [ns]
};

/// An edge of the graph, by the indices of its nodes.
struct NodeEdge {
  int from = 0;  ///< runs first
  int to = 0;    ///< waits for it
};

/// The graph of one pass of a step as data: nodes by index.
struct TracedGraph {
  std::vector<graph::NodeLabel> labels;   ///< of nodes; their passes are -1
  std::vector<std::string> names;         ///< of nodes: "blade 2 / body 3 / inverse"
  std::string subsystem_word;             ///< word for a subsystem: "blade"
  std::vector<NodeEdge> edges;            ///< within a pass; from a lower index to a higher one
  std::vector<NodeEdge> next_pass_edges;  ///< from a node of a pass to one of the next pass
  std::vector<std::string> subsystems{};  ///< their names by index, which begin those of nodes

  /// Returns the name of a subsystem; "blade 2" where it has none.
  std::string name_of_subsystem(int subsystem) const {
    const auto k = static_cast<std::size_t>(subsystem);
    return k < subsystems.size() ? subsystems[k]
                                 : subsystem_word + " " + std::to_string(subsystem + 1);
  }
  /// Returns the number of nodes, that of labels and names.
  int node_count() const { return static_cast<int>(labels.size()); }
};

/// Progress of an executor that chooses how to run the steps.
enum class ChoiceState {
  made,    ///< it had chosen, or does not choose
  none,    ///< it had not chosen yet, and ran the steps serially
  tuning,  ///< it had tried alternatives, and ran these steps serially
};

/// A recording of steps. In a step and pass each node has one slice, with two exceptions: a
/// subsystem that needs fewer passes than others has none in the surplus passes; and where blades
/// run ahead of one another (window_steps > 1 under a prescribed hub), the node "hub solve" runs
/// once for all steps that a run completes, and its slice belongs to the last of them.
struct SPOKE_EXPORT StepTrace {
  TracedGraph graph;               ///< of one pass
  std::vector<TracedStep> steps;   ///< steps that were recorded as a whole, ascending
  std::vector<NodeSlice> slices;   ///< in order of begin; of these steps and of surplus passes
  std::vector<TracedRun> runs;     ///< of the executor
  int threads = 1;                 ///< on which the steps ran, the calling one included
  int window_steps = 1;            ///< approximate number of steps in a run of the executor
  std::int64_t dropped_steps = 0;  ///< made, but not recorded for lack of memory
  double recording_cost = 0.0;     ///< time of the two time stamps of a slice [s]
  std::string executor;            ///< one line about what ran the steps
  /// Progress of the choice of the executor.
  ChoiceState choice = ChoiceState::made;
  /// Steps in a window of the executor if these steps, being less than half a window, ran without;
  /// else 0.
  int unused_window = 0;
  /// Number of steps that were asked for. If it exceeds recorded and dropped steps together, the
  /// simulation ended or was stopped early.
  std::int64_t asked_steps = 0;
  /// TraceOptions::buffer_bytes that would hold the first of the steps, recorded or not; 0: it was
  /// not made.
  std::size_t bytes_of_first = 0;
  /// TraceOptions::buffer_bytes that would hold all runs that the executor has made.
  std::size_t bytes_of_all = 0;

  /// Returns the slices of a step in order of begin; none for a step that is not in `steps`.
  std::vector<NodeSlice> slices_of(std::int64_t step) const;
  /// Adds the recording of later steps of the same simulation. Their times follow the end of this
  /// recording: the time between the two recordings is left out. `threads` and `window_steps`
  /// become the larger ones; `executor` stays that of the earlier steps.
  void append(const StepTrace& later);
};

/// Called with a step that is complete and its slices in order of begin, valid during the call.
using SliceObserver =
    std::function<void(const TracedStep& step, std::span<const NodeSlice> slices)>;

/// Options of Simulation::trace().
struct TraceOptions {
  /// Largest memory for the recording of all threads [bytes]. The result of trace() is made from it
  /// afterwards, and takes memory of its own.
  std::size_t buffer_bytes = std::size_t{256} << 20;
  /// Called for every step as it is finished, in order, on the calling thread while no node runs;
  /// not for dropped steps. May be empty.
  SliceObserver finished;
  /// Called before trace() throws, with the recording of the complete steps, which may be empty.
  /// May be empty.
  std::function<void(StepTrace)> unfinished;
};

}  // namespace spoke
