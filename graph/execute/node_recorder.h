#pragma once

// Records which thread runs which node when. All executors run nodes by run_nodes().

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/machine/time_stamp.h"
#include "graph/step_graph.h"

namespace spoke::graph {

/// A run of a node: when, in ticks of time_stamp(), and in which cluster of the executor's plan
/// (-1: the executor has no plan). Where nodes follow each other without a pause, the end of one is
/// the begin of the next.
struct NodeRecord {
  std::int32_t node = -1;
  std::int32_t cluster = -1;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

/// The room of a NodeRecorder.
struct RecorderRoom {
  std::size_t runs = 0;
  std::size_t records_per_thread = 0;
};

/// Returns room for `runs` runs of `nodes` nodes, whichever threads they run on, or for fewer where
/// that takes more than `most_bytes`.
RecorderRoom make_room(std::size_t runs, int nodes, int threads, std::size_t most_bytes);

/// Records which thread runs which node when, for an executor that is told to by
/// Executor::set_recorder(). Each thread writes to memory of its own, all of it allocated in the
/// constructor. Runs are recorded as a whole or not at all: if a thread has no room left for all
/// nodes of one more run, that run is not recorded, only counted.
class NodeRecorder {
 public:
  /// The records of one thread. Members are plain, so that executors that the thread sanitizer does
  /// not watch (thread_sanitizer.h) share no function with files that it does.
  struct alignas(128) Lane {     // 128: processors fetch cache lines in pairs
    NodeRecord* next = nullptr;  ///< place of the next record
    std::vector<NodeRecord> records;
  };

  /// The time from before the first node to after the last [ticks].
  struct Run {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
  };

  /// Makes a recorder for an executor whose threads().total() is `threads`, on a graph of `nodes`
  /// nodes.
  NodeRecorder(int threads, int nodes, const RecorderRoom& room);

  int threads() const { return static_cast<int>(lanes_.size()); }

  /// Begins a run; to be called on the calling thread while no node runs. Returns whether the run
  /// is recorded. Without this call nothing is.
  bool begin_run() noexcept;
  /// Ends the run; to be called on the calling thread while no node runs.
  void end_run() noexcept;

  /// Whether nodes are to be recorded, between begin_run() and end_run().
  bool is_recording() const { return is_recording_; }
  /// Returns the lane in which thread `thread` of the executor records, 0 <= thread < threads(); 0
  /// is the calling one.
  Lane& lane(int thread) { return lanes_[static_cast<std::size_t>(thread)]; }

  int runs() const { return static_cast<int>(runs_); }  ///< recorded
  int dropped_runs() const { return dropped_; }         ///< runs not recorded for want of room
  const Run& run(int index) const { return run_times_[static_cast<std::size_t>(index)]; }
  /// Returns the nodes that a thread ran in a run, in order.
  std::span<const NodeRecord> records(int run, int thread) const;

  /// Forgets all runs.
  void clear() noexcept;

 private:
  std::size_t end_place(std::size_t run, std::size_t thread) const {
    return run * lanes_.size() + thread;
  }

  std::size_t nodes_;
  std::vector<Lane> lanes_;
  std::vector<Run> run_times_;     // as many runs as there is room for
  std::vector<std::size_t> ends_;  // end of the records per run and thread
  std::size_t runs_ = 0;
  int dropped_ = 0;
  bool is_recording_ = false;
};

/// Runs nodes of a cluster one after the other by `run_node(NodeId)`, on thread `thread`
/// of an executor, and records them if there is a recorder that records. Costs a branch if there is
/// none.
template <class RunNode>
void run_nodes(NodeRecorder* recorder, int thread, int cluster, std::span<const NodeId> nodes,
               RunNode run_node) {
  if (recorder == nullptr || !recorder->is_recording()) {
    for (const NodeId node : nodes) run_node(node);
    return;
  }
  // The memory was last written by another thread: it is fetched while the nodes run.
  constexpr std::ptrdiff_t ahead = 8;  // records, three cache lines
  NodeRecorder::Lane& lane = recorder->lane(thread);
  NodeRecord* record = lane.next;
  std::uint64_t before = time_stamp_after_reads();
  for (const NodeId node : nodes) {
    __builtin_prefetch(record + ahead, 1);
    record->node = node.index;
    record->cluster = cluster;
    record->begin = before;
    run_node(node);
    before = record->end = time_stamp();
    ++record;
  }
  lane.next = record;
}

}  // namespace spoke::graph
