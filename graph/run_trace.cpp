// Records one run and sorts its nodes by time.

#include "graph/run_trace.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "graph/execute/node_recorder.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {

RunTrace trace_run(const StepGraph& graph, Executor& executor) {
  const int threads = executor.threads().total();
  constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
  NodeRecorder recorder(threads, graph.node_count(),
                        make_room(1, graph.node_count(), threads, no_limit));
  executor.set_recorder(&recorder);
  recorder.begin_run();
  executor.run();
  recorder.end_run();
  executor.set_recorder(nullptr);

  const NodeRecorder::Run& run = recorder.run(0);
  const auto seconds_since_begin = [&](std::uint64_t ticks) {
    return static_cast<double>(ticks - run.begin) * time_stamp_scale().seconds_per_tick;
  };
  RunTrace trace;
  trace.duration = seconds_since_begin(run.end);
  for (int thread = 0; thread < threads; ++thread)
    for (const NodeRecord& record : recorder.records(0, thread))
      trace.nodes.push_back({{record.node},
                             thread,
                             seconds_since_begin(record.begin),
                             seconds_since_begin(record.end)});
  std::stable_sort(trace.nodes.begin(), trace.nodes.end(),
                   [](const NodeRun& a, const NodeRun& b) { return a.begin < b.begin; });
  return trace;
}

}  // namespace spoke::graph
