// Adds up the nodes of subsystems by process, and the messages between processes.

#include "bench/predict/ranks.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "engine/step/stages.h"

namespace spoke::predict {
namespace {

/// Whether a pass ends with the node: that of a subsystem, or of all subsystems together.
bool is_finish(const graph::Node& node) { return node.label.stage == stages::kFinish.name; }

}  // namespace

StepShares find_shares(const graph::StepGraph& graph, const NodeMeasurement& nodes, int window) {
  StepShares shares;
  int common_passes = 0;  // passes of all subsystems together
  for (int n = 0; n < graph.node_count(); ++n) {
    const graph::Node& node = graph.node({n});
    const double cost = nodes.runs_per_step * nodes.costs[static_cast<std::size_t>(n)];
    const int subsystem = node.label.subsystem;
    if (subsystem < 0) {
      shares.common += cost;
      if (is_finish(node)) ++common_passes;
      continue;
    }
    const auto index = static_cast<std::size_t>(subsystem);
    if (index >= shares.subsystems.size()) shares.subsystems.resize(index + 1);
    shares.subsystems[index] += cost;
  }
  shares.common += nodes.runs_per_step * nodes.between_runs;
  shares.exchanges = 2.0 * nodes.runs_per_step * common_passes + 1.0 / window;
  return shares;
}

std::vector<RankPoint> predict_ranks(const StepShares& shares, const Network& network,
                                     std::span<const int> ranks,
                                     const std::function<std::vector<int>(int)>& share_out) {
  std::vector<RankPoint> points;
  for (const int count : ranks) {
    const std::vector<int> first = share_out(count);
    double most = 0.0;
    for (std::size_t r = 0; r + 1 < first.size(); ++r)
      most = std::max(most, std::accumulate(shares.subsystems.begin() + first[r],
                                            shares.subsystems.begin() + first[r + 1], 0.0));
    const auto rounds = static_cast<double>(std::bit_width(static_cast<unsigned>(count - 1)));
    points.push_back({count, shares.common + most, shares.exchanges * rounds * network.latency});
  }
  return points;
}

}  // namespace spoke::predict
