// A trace: which node ran when on which thread, in ten steps, by stage; and whether each node
// waited for those that it depends on.

#include <spoke/spoke.h>

#include <algorithm>
#include <cstdio>
#include <map>

int main() {
  const spoke::Scenario scenario = spoke::parse_scenario(R"(
[hub]
drive = { kind = "spin_up", speed = 4.0, ramp = 15.0 }
[blade]
count = 3
length = 8.0
bodies = 4
elements = 16
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.005
duration = 2.0
)",
                                                         "trace_from_code");
  spoke::Simulation simulation(scenario,
                               {.executor = spoke::ExecutorKind::flow_graph, .threads = 2});
  simulation.run_until(1.0);
  const spoke::StepTrace trace = simulation.trace(10);

  std::map<std::string, double> microseconds;  // by stage
  std::map<std::pair<std::int64_t, int>, std::map<int, spoke::NodeSlice>> passes;
  for (const spoke::NodeSlice& slice : trace.slices) {
    const std::string& stage = trace.graph.labels[static_cast<std::size_t>(slice.node)].stage;
    microseconds[stage] += 1e-3 * static_cast<double>(slice.end - slice.begin);
    if (slice.step >= 0) passes[{slice.step, slice.pass}][slice.node] = slice;
  }
  for (const auto& [stage, time] : microseconds)
    std::printf("%-12s %8.1f us\n", stage.c_str(), time);

  int checked = 0, early = 0;
  for (const auto& [pass, nodes] : passes)
    for (const spoke::NodeEdge& edge : trace.graph.edges) {
      const auto from = nodes.find(edge.from), to = nodes.find(edge.to);
      if (from == nodes.end() || to == nodes.end()) continue;
      ++checked;
      early += to->second.begin < from->second.end ? 1 : 0;
    }
  std::printf("%zu steps, %d dependencies kept, %d not\n", trace.steps.size(), checked - early,
              early);
  return trace.steps.size() == 10 && checked > 0 && early == 0 ? 0 : 1;
}
