// Runs the same work on one thread and on all at once, for a millisecond or two.

#include "graph/calibrate/capacity.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <string>

#include "graph/execute/executor_kinds.h"
#include "graph/execute/unbound_thread.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {
namespace {

// Runs a chain of dependent multiplications, which is the same work wherever it runs.
void work(int iterations) noexcept {
  volatile double sink = 1.0;
  double value = sink;
  for (int k = 0; k < iterations; ++k) value = value * 0.999999 + 1e-9;
  sink = value;
}

// Makes a node of that work for each thread, independent of the others.
StepGraph make_busy_graph(int threads, int iterations) {
  StepGraphBuilder builder;
  for (int k = 0; k < threads; ++k)
    builder.add_node({"busy", k}, {}, writes(builder.add_part("busy " + std::to_string(k), {})),
                     [iterations]() noexcept { work(iterations); });
  return builder.build();
}

double seconds_of(Executor& executor) {
  const std::uint64_t begin = time_stamp();
  executor.run();
  return seconds_since(begin);
}

}  // namespace

double measure_capacity(int threads, double seconds) {
  assert(threads >= 1);
  if (threads == 1) return 1.0;
  constexpr int iterations = 20'000;  // some 50 us
  const UnboundThread unbound;        // oneTBB's threads get the processors that this one has
  const StepGraph graph = make_busy_graph(threads, iterations);
  const auto together = make_flow_graph_executor(graph, plan_of_single_nodes(graph), threads);
  for (int k = 0; k < 2; ++k) together->run();  // wakes the threads
  double alone = 0.0, at_once = 0.0;
  do {
    const std::uint64_t begin = time_stamp();
    work(iterations);
    alone += seconds_since(begin);
    at_once += seconds_of(*together);
  } while (alone + at_once < seconds);
  return std::min(threads * alone / at_once, static_cast<double>(threads));
}

}  // namespace spoke::graph
