#include "graph/data_traffic.h"

#include <utility>

namespace spoke::graph {

DataTraffic::DataTraffic(const StepGraph& graph, double seconds_per_byte)
    : graph_(graph), holders_(graph.parts().size(), -1) {
  seconds_.reserve(holders_.size());
  for (const Part& part : graph.parts()) {
    std::size_t bytes = 0;
    for (const std::span<double> range : part.memory) bytes += range.size_bytes();
    seconds_.push_back(seconds_per_byte * static_cast<double>(bytes));
  }
}

double DataTraffic::run(NodeId node, int processor) {
  double seconds = 0.0;
  const auto touch = [&](PartId part) {
    const auto index = static_cast<std::size_t>(part.index);
    const int before = std::exchange(holders_[index], processor);
    if (before >= 0 && before != processor) seconds += seconds_[index];
  };
  for (const PartId part : graph_.node(node).reads) touch(part);
  for (const PartId part : graph_.node(node).writes) touch(part);
  return seconds;
}

}  // namespace spoke::graph
