// Manages room, beginning and end of recorded runs.

#include "graph/execute/node_recorder.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace spoke::graph {

RecorderRoom make_room(std::size_t runs, int nodes, int threads, std::size_t most_bytes) {
  const auto thread_count = static_cast<std::size_t>(std::max(threads, 1));
  const std::size_t most = most_bytes / (thread_count * sizeof(NodeRecord));
  return {runs, std::min(runs * static_cast<std::size_t>(nodes), most)};
}

NodeRecorder::NodeRecorder(int threads, int nodes, const RecorderRoom& room)
    : nodes_(static_cast<std::size_t>(nodes)),
      lanes_(static_cast<std::size_t>(threads)),
      run_times_(room.runs),
      ends_(room.runs * lanes_.size()) {
  for (Lane& lane : lanes_) lane.records.resize(room.records_per_thread);
  clear();
}

void NodeRecorder::clear() noexcept {
  for (Lane& lane : lanes_) lane.next = lane.records.data();
  runs_ = 0;
  dropped_ = 0;
  is_recording_ = false;
}

bool NodeRecorder::begin_run() noexcept {
  is_recording_ = runs_ < run_times_.size() &&
                  std::all_of(lanes_.begin(), lanes_.end(), [this](const Lane& lane) {
                    const NodeRecord* end = lane.records.data() + lane.records.size();
                    return static_cast<std::size_t>(end - lane.next) >= nodes_;
                  });
  if (is_recording_)
    run_times_[runs_].begin = time_stamp();
  else
    ++dropped_;
  return is_recording_;
}

void NodeRecorder::end_run() noexcept {
  if (!is_recording_) return;
  is_recording_ = false;
  run_times_[runs_].end = time_stamp_after_reads();  // no earlier than the last node of any thread
  for (std::size_t thread = 0; thread < lanes_.size(); ++thread) {
    const Lane& lane = lanes_[thread];
    ends_[end_place(runs_, thread)] = static_cast<std::size_t>(lane.next - lane.records.data());
  }
  ++runs_;
}

std::span<const NodeRecord> NodeRecorder::records(int run, int thread) const {
  assert(run >= 0 && std::cmp_less(run, runs_));
  assert(thread >= 0 && std::cmp_less(thread, lanes_.size()));
  const auto r = static_cast<std::size_t>(run);
  const auto t = static_cast<std::size_t>(thread);
  const std::size_t begin = r == 0 ? 0 : ends_[end_place(r - 1, t)];
  return std::span(lanes_[t].records).subspan(begin, ends_[end_place(r, t)] - begin);
}

}  // namespace spoke::graph
