// A step graph of one's own, without mechanics: heat spreads over a plate that is cut into strips.
// The nodes' declarations are checked, and all executors run the graph, traced, with the same bits.

#include <spoke/spoke.h>

#include <algorithm>
#include <cstdio>

namespace graph = spoke::graph;
using Plate = std::vector<double>;  // temperatures, row by row
constexpr int rows = 128, columns = 1024, strips = 8, size = rows * columns / strips, sweeps = 10;

/// Sets each point of a strip of `to` to the mean of its neighbours; the plate's edge stays.
void relax(const Plate& from, Plate& to, int strip) noexcept {
  for (int k = strip * size; k < (strip + 1) * size; ++k) {
    const int row = k / columns, column = k % columns;
    const bool is_edge = row % (rows - 1) == 0 || column % (columns - 1) == 0;
    to[k] = is_edge ? from[k]
                    : 0.25 * (from[k - columns] + from[k - 1] + from[k + 1] + from[k + columns]);
  }
}

/// Builds sweeps from one plate to the other and back. A strip waits for itself and its neighbours.
graph::StepGraph build_sweeps(Plate (&plates)[2]) {
  graph::StepGraphBuilder builder("strip");
  std::vector<graph::PartId> parts[2];  // parts of each plate, by strip
  for (const int p : {0, 1})
    for (int i = 0; i < strips; ++i) {
      const std::string name = "plate " + std::to_string(p + 1) + ", " + std::to_string(i + 1);
      parts[p].push_back(builder.add_part(name, {graph::bytes_of(plates[p][i * size], size)}));
    }
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int i = 0; i < strips; ++i) {
      const int from = sweep % 2, to = 1 - from, last = std::min(i + 1, strips - 1);
      const std::vector read(&parts[from][std::max(i - 1, 0)], &parts[from][last] + 1);
      builder.add_node({"relax", i, -1, sweep}, graph::reads(read), graph::writes(parts[to][i]),
                       [&plates, from, to, i]() noexcept { relax(plates[from], plates[to], i); });
    }
  return builder.build();
}

int main() {
  Plate first, plates[2] = {Plate(rows * columns), Plate(rows * columns)};
  const graph::StepGraph sweep_graph = build_sweeps(plates);
  bool is_fine = graph::check_declarations(sweep_graph).empty();
  for (const graph::ExecutorKind kind : graph::executor_kinds()) {
    std::fill(plates[0].begin(), plates[0].end(), 0.0);
    std::fill_n(plates[0].begin(), columns, 100.0);  // one edge is hot
    const auto executor = graph::make_executor(sweep_graph, kind, 2);
    const graph::RunTrace trace = graph::trace_run(sweep_graph, *executor);
    double busy = 0.0;
    for (const graph::NodeRun& run : trace.nodes) busy += run.end - run.begin;
    std::printf("%-14s %5.0f us, %.2f nodes at once, at last %s\n", graph::name_of(kind).data(),
                1e6 * trace.duration, busy / trace.duration,
                sweep_graph.name_of(trace.nodes.back().node).c_str());
    if (first.empty()) first = plates[0];
    is_fine &= plates[0] == first;
  }
  return is_fine ? 0 : 1;
}
