#include "graph/data_traffic.h"

#include <utility>

namespace spoke::graph {

DataTraffic::DataTraffic(const StepGraph& graph, const Transfer& transfer)
    : graph_(graph), latency_(transfer.latency), holders_(graph.parts().size(), -1) {
  seconds_.reserve(holders_.size());
  for (const Part& part : graph.parts()) {
    std::size_t bytes = 0;
    for (const std::span<double> range : part.memory) bytes += range.size_bytes();
    seconds_.push_back(transfer.per_byte * static_cast<double>(bytes));
  }
}

double DataTraffic::run(NodeId node, int processor) {
  double seconds = 0.0;
  bool is_waiting = false;
  const auto touch = [&](PartId part) {
    const auto index = static_cast<std::size_t>(part.index);
    const int before = std::exchange(holders_[index], processor);
    if (before < 0 || before == processor || graph_.parts()[index].memory.empty()) return;
    seconds += seconds_[index];
    is_waiting = true;
  };
  for (const PartId part : graph_.node(node).reads) touch(part);
  for (const PartId part : graph_.node(node).writes) touch(part);
  return is_waiting ? latency_ + seconds : seconds;
}

}  // namespace spoke::graph
