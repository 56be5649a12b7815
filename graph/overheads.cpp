#include "graph/overheads.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "graph/executor_kinds.h"
#include "graph/time_stamp.h"

namespace spoke::graph {
namespace {

constexpr double kBusy = 20e-6;  // s

void be_busy() noexcept {
  const auto ticks = static_cast<std::uint64_t>(kBusy / time_stamp_scale().seconds_per_tick);
  const std::uint64_t begin = time_stamp();
  while (time_stamp() - begin < ticks) {
  }
}

double seconds_since(std::uint64_t begin) {
  return static_cast<double>(time_stamp() - begin) * time_stamp_scale().seconds_per_tick;
}

// The lower quartile: what disturbs only adds. Threads that are new or asleep take milliseconds to
// join.
double seconds_per_run(Executor& executor, int runs) {
  constexpr double warm_up = 5e-3;  // s
  const std::uint64_t start = time_stamp();
  while (seconds_since(start) < warm_up) executor.run();
  std::vector<double> seconds;
  for (int k = 0; k < runs; ++k) {
    const std::uint64_t begin = time_stamp();
    executor.run();
    seconds.push_back(seconds_since(begin));
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 4];
}

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
  for (const PartId end : ends) builder.add_node({"busy"}, reads(root), writes(end), be_busy);
  builder.add_node({"join"}, reads(ends), {}, []() noexcept {});
  const StepGraph graph = builder.build();
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), 2);
  return 0.5 * (seconds_per_run(*executor, 200) - kBusy);
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
