// Follows who holds which cache lines, and what a node waits for.

#include "graph/simulate/data_traffic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace spoke::graph {
namespace {

constexpr double kLine = 64;  // bytes
// How far ahead in a node a processor fetches what it will need, some hundred instructions [s].
constexpr double kLookAhead = 100e-9;

struct Lines {
  std::uintptr_t first, end;
};

Lines lines_of(std::span<const std::byte> range) {
  constexpr auto line = static_cast<std::uintptr_t>(kLine);
  const auto begin = reinterpret_cast<std::uintptr_t>(range.data());
  return {begin / line, (begin + range.size_bytes() + line - 1) / line};
}

/// Cache lines of a part that a node touches. Ranges may share some.
double count_lines(const Part& part) {
  if (part.record_size > 0) return std::ceil(static_cast<double>(part.record_size) / kLine);
  std::vector<Lines> ranges;
  for (const std::span<std::byte> range : part.memory)
    if (!range.empty()) ranges.push_back(lines_of(range));
  std::sort(ranges.begin(), ranges.end(),
            [](const Lines& a, const Lines& b) { return a.first < b.first; });
  std::uintptr_t count = 0;
  std::uintptr_t counted_to = 0;
  for (const Lines& lines : ranges) {
    const std::uintptr_t first = std::max(lines.first, counted_to);
    if (lines.end <= first) continue;
    count += lines.end - first;
    counted_to = lines.end;
  }
  return static_cast<double>(count);
}

/// An entry of a list that grows as it is needed.
template <class Value>
Value& entry(std::vector<Value>& list, int index, Value initial) {
  const auto place = static_cast<std::size_t>(index);
  if (place >= list.size()) list.resize(place + 1, initial);
  return list[place];
}

/// Makes `processor` the one that changed something last; whether that was another.
bool passes_to(int processor, int& last) {
  const int before = std::exchange(last, processor);
  return before != -1 && before != processor;
}

}  // namespace

DataTraffic::DataTraffic(const StepGraph& graph, const Transfer& transfer, Writing writing)
    : graph_(graph),
      writing_(writing),
      latency_(transfer.latency),
      line_(transfer.latency + kLine * transfer.per_byte),
      holders_(graph.parts().size()) {
  seconds_.reserve(holders_.size());
  for (const Part& part : graph.parts())
    seconds_.push_back(kLine * transfer.per_byte * count_lines(part));
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

double DataTraffic::wait_at_barrier(int processor) {
  return std::exchange(entry(is_to_wait_, processor, '\0'), '\0') != 0 ? latency_ : 0.0;
}

double DataTraffic::notify(int cluster, int processor) {
  return passes_to(processor, entry(tellers_, cluster, -1)) ? line_ : 0.0;
}

double DataTraffic::start_cluster(int cluster, int processor) {
  const bool comes_from_another = passes_to(processor, entry(starters_, cluster, -1));
  return comes_from_another && entry(tellers_, cluster, -1) != processor ? line_ : 0.0;
}

double DataTraffic::run(NodeId node, int processor, double cost) {
  double seconds = 0.0;
  double waits = 0.0;
  bool is_copied_elsewhere = false;  // what it writes
  const auto touch = [&](PartId part) {
    const auto index = static_cast<std::size_t>(part.index);
    if (!fetch(index, processor)) return;
    seconds += seconds_[index];
    ++waits;
  };
  for (const PartId part : graph_.node(node).reads) touch(part);
  for (const PartId part : graph_.node(node).writes) {
    const auto index = static_cast<std::size_t>(part.index);
    is_copied_elsewhere |= is_copied(index);
    touch(part);
    holders_[index].assign(1, processor);
  }
  if (is_copied_elsewhere && writing_ == Writing::at_once) waits = std::max(waits, 1.0);
  if (is_copied_elsewhere && writing_ == Writing::at_barriers)
    entry(is_to_wait_, processor, '\0') = 1;
  return latency_ * std::min(waits, 1.0 + std::floor(cost / kLookAhead)) + seconds;
}

}  // namespace spoke::graph
