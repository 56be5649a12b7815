#include "graph/data_traffic.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace spoke::graph {
namespace {

constexpr double kCacheLine = 64;  // bytes

/// That a node touches.
std::size_t bytes_of(const Part& part) {
  if (part.record_size > 0) return part.record_size * sizeof(double);
  std::size_t bytes = 0;
  for (const std::span<double> range : part.memory) bytes += range.size_bytes();
  return bytes;
}

}  // namespace

DataTraffic::DataTraffic(const StepGraph& graph, const Transfer& transfer, Writing writing)
    : graph_(graph),
      writing_(writing),
      latency_(transfer.latency),
      cluster_record_(2.0 * (transfer.latency + kCacheLine * transfer.per_byte)),
      holders_(graph.parts().size()) {
  seconds_.reserve(holders_.size());
  for (const Part& part : graph.parts())
    seconds_.push_back(transfer.per_byte * static_cast<double>(bytes_of(part)));
}

/// Gives the processor a copy. Whether it has to wait for it.
bool DataTraffic::fetch(std::size_t part, int processor) {
  std::vector<int>& holders = holders_[part];
  if (std::find(holders.begin(), holders.end(), processor) != holders.end()) return false;
  holders.push_back(processor);
  return holders.size() > 1 && !graph_.parts()[part].memory.empty();
}

/// Whether several processors hold it.
bool DataTraffic::is_copied(std::size_t part) const {
  return holders_[part].size() > 1 && !graph_.parts()[part].memory.empty();
}

double DataTraffic::start_cluster(int cluster, int processor) {
  const auto index = static_cast<std::size_t>(cluster);
  if (index >= starters_.size()) starters_.resize(index + 1, -1);
  const int before = std::exchange(starters_[index], processor);
  return before == -1 || before == processor ? 0.0 : cluster_record_;
}

double DataTraffic::run(NodeId node, int processor) {
  double seconds = 0.0;
  bool is_waiting = false;
  const auto touch = [&](PartId part) {
    const auto index = static_cast<std::size_t>(part.index);
    if (!fetch(index, processor)) return;
    seconds += seconds_[index];
    is_waiting = true;
  };
  for (const PartId part : graph_.node(node).reads) touch(part);
  for (const PartId part : graph_.node(node).writes) {
    const auto index = static_cast<std::size_t>(part.index);
    if (writing_ == Writing::waits) is_waiting |= is_copied(index);
    touch(part);
    holders_[index].assign(1, processor);
  }
  return is_waiting ? latency_ + seconds : seconds;
}

}  // namespace spoke::graph
