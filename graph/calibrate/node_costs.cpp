// Robust means of the nodes' times.

#include "graph/calibrate/node_costs.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

#include "graph/calibrate/quantiles.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {

void NodeCosts::run() {
  const std::span<const NodeId> order = graph_.serial_order();
  const std::size_t begin = ticks_.size();
  ticks_.resize(begin + order.size());
  const std::uint64_t first = time_stamp();
  std::uint64_t before = first;
  for (std::size_t k = 0; k < order.size(); ++k) {
    graph_.run_node(order[k]);
    const std::uint64_t now = time_stamp();
    ticks_[begin + k] = now - before;
    before = now;
  }
  seconds_ += static_cast<double>(before - first) * time_stamp_scale().seconds_per_tick;
  ++runs_;
}

std::vector<double> NodeCosts::costs() const {
  assert(runs_ > 0);
  const TimeStampScale& scale = time_stamp_scale();
  const std::span<const NodeId> order = graph_.serial_order();
  std::vector<double> costs(order.size());
  std::vector<std::uint64_t> samples(static_cast<std::size_t>(runs_));
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (std::size_t run = 0; run < samples.size(); ++run) {
      samples[run] = ticks_[run * order.size() + k];
    }
    const double seconds = robust_mean(samples) * scale.seconds_per_tick - scale.cost;
    costs[static_cast<std::size_t>(order[k].index)] = std::max(seconds, 0.0);
  }
  return costs;
}

}  // namespace spoke::graph
