#pragma once

// The memory of a context, and what of it parts cover.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "engine/step/step_context.h"
#include "graph/step_graph.h"

namespace spoke::test {

using Range = std::span<std::byte>;

/// Memory under a name.
struct Watched {
  std::string name;
  Range memory;
};

template <class T>
Range bytes_in(T& object) {
  return std::as_writable_bytes(std::span(&object, 1));
}

/// Lists all memory of a context but that of matrices on the heap.
template <class World>
std::vector<Watched> watch(SystemContext<World>& context) {
  StepData<World>& data = context.data;
  std::vector<Watched> watched{{"the table", bytes_in(data)},
                               {"progress", std::as_writable_bytes(std::span(data.progress))},
                               {"records", std::as_writable_bytes(std::span(data.records))},
                               {"rotors", std::as_writable_bytes(std::span(data.rotors))}};
  for (SubsystemData<World>& subsystem : data.subsystems) {
    watched.push_back({"a subsystem", bytes_in(subsystem)});
    for (BodyData<World>& body : subsystem.bodies) watched.push_back({"a body", bytes_in(body)});
    for (const Range chunk : subsystem.arena->memory()) watched.push_back({"an arena", chunk});
  }
  for (auto& work : context.work.structured) watched.push_back({"structured work", bytes_in(work)});
  return watched;
}

inline void sort_by_place(std::vector<Range>& ranges) {
  std::sort(ranges.begin(), ranges.end(), [](Range a, Range b) { return a.data() < b.data(); });
}

/// The bytes that some parts cover, ascending, without overlaps. counts(part): whether it is one.
template <class Counts>
std::vector<Range> covered_by(const graph::StepGraph& graph, const Counts& counts) {
  std::vector<Range> covered;
  for (const graph::Part& part : graph.parts())
    if (counts(part)) covered.insert(covered.end(), part.memory.begin(), part.memory.end());
  sort_by_place(covered);
  return covered;
}

/// Whether a byte is in one of some ranges, which are sorted and do not overlap.
inline bool is_covered(const std::vector<Range>& covered, const std::byte* byte) {
  const auto behind = std::upper_bound(covered.begin(), covered.end(), byte,
                                       [](const std::byte* at, Range r) { return at < r.data(); });
  return behind != covered.begin() && byte < std::prev(behind)->data() + std::prev(behind)->size();
}

/// Returns the first byte of a range that is not what it was and that no part covers; null: none.
inline const std::byte* find_outside(Range now, const std::vector<std::byte>& before,
                                     const std::vector<Range>& covered) {
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k] != before[k] && !is_covered(covered, &now[k])) return &now[k];
  return nullptr;
}

}  // namespace spoke::test
