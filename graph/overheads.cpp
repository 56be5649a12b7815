#include "graph/overheads.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "graph/executor_kinds.h"
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"

namespace spoke::graph {
namespace {

constexpr double kBusy = 20e-6;  // s

// Two chains, since a single one would need no flow graph.
double measure_cluster() {
  constexpr int links = 200;
  StepGraphBuilder builder;
  const std::array parts{builder.add_part("a", {}), builder.add_part("b", {})};
  for (std::size_t k = 0; k < links; ++k) {
    const PartId part = parts[k % 2];
    builder.add_node({"link"}, reads(part), writes(part), []() noexcept {});
  }
  const StepGraph graph = builder.build();
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), 1);
  return seconds_per_run(*executor, 30) / links;
}

// A fork and join of two nodes takes one of them, one handover to the other thread and one back.
double measure_handover() {
  StepGraphBuilder builder;
  const PartId root = builder.add_part("root", {});
  const std::vector<PartId> ends{builder.add_part("a", {}), builder.add_part("b", {})};
  builder.add_node({"root"}, {}, writes(root), []() noexcept {});
  for (const PartId end : ends)
    builder.add_node({"busy"}, reads(root), writes(end), []() noexcept { be_busy(kBusy); });
  builder.add_node({"join"}, reads(ends), {}, []() noexcept {});
  const StepGraph graph = builder.build();
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), 2);
  // A thread that is new or asleep takes milliseconds to join, on a virtual machine tens of them.
  constexpr double patience = 0.1;   // s
  constexpr double joined = 2.0e-6;  // s, less than that only with another thread
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint64_t begin = time_stamp();
       least > joined && seconds_since(begin) < patience;) {
    least = std::min(least, 0.5 * (seconds_per_run(*executor, 100) - kBusy));
  }
  return least;
}

Overheads measure() {
  Overheads overheads;
  overheads.per_cluster = std::clamp(measure_cluster(), 50e-9, 1e-6);
  overheads.handover = std::clamp(measure_handover(), 0.5e-6, 5e-6);
  return overheads;
}

}  // namespace

const Overheads& flow_graph_overheads() {
  static const Overheads overheads = measure();
  return overheads;
}

}  // namespace spoke::graph
