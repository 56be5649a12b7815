// Follows who holds which parts, and what a node waits for.

#include "graph/simulate/data_traffic.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

double seconds_of(const Part& part, const Transfer& transfer) {
  std::size_t bytes = 0;
  for (const std::span<std::byte> range : part.memory) bytes += range.size_bytes();
  if (bytes == 0) return 0.0;
  if (part.record_size > 0) bytes = part.record_size;
  return transfer.latency + transfer.per_byte * static_cast<double>(bytes);
}

}  // namespace

DataTraffic::DataTraffic(const StepGraph& graph, const Transfer& transfer)
    : graph_(graph), holders_(graph.parts().size()) {
  seconds_.reserve(holders_.size());
  for (const Part& part : graph.parts()) seconds_.push_back(seconds_of(part, transfer));
}

double DataTraffic::fetch(PartId part, int processor) {
  std::vector<int>& holders = holders_[index_of(part)];
  if (std::find(holders.begin(), holders.end(), processor) != holders.end()) return 0.0;
  holders.push_back(processor);
  return holders.size() > 1 ? seconds_[index_of(part)] : 0.0;
}

double DataTraffic::run(NodeId node, int processor) {
  double seconds = 0.0;
  for (const PartId part : graph_.node(node).reads) seconds += fetch(part, processor);
  for (const PartId part : graph_.node(node).writes) {
    seconds += fetch(part, processor);
    holders_[index_of(part)].assign(1, processor);  // the others give up their copies
  }
  return seconds;
}

}  // namespace spoke::graph
