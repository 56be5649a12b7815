#pragma once

#include <compare>
#include <type_traits>
#include <vector>

namespace spoke::graph {

/// Handle of one part of the step's data, given out by StepGraphBuilder::add_part().
struct PartId {
  int index = -1;  ///< in the order of addition
  /// By index.
  friend auto operator<=>(const PartId&, const PartId&) = default;
};

/// The parts a node reads. Made by reads().
struct Reads {
  std::vector<PartId> parts;  ///< in any order
};

/// The parts a node writes. Made by writes(). A part that is read as well is updated in place;
/// one that is only written must be written in full.
struct Writes {
  std::vector<PartId> parts;  ///< in any order
};

namespace detail {

/// A template, for compilers then look into it only where it is used.
template <class Parts>
void append(std::vector<PartId>& list, const Parts& parts) {
  if constexpr (std::is_same_v<Parts, PartId>) {
    list.push_back(parts);
  } else {
    for (const PartId part : parts) list.push_back(part);
  }
}

template <class... Parts>
std::vector<PartId> joined(const Parts&... parts) {
  std::vector<PartId> list;
  (append(list, parts), ...);
  return list;
}

}  // namespace detail

/// Declares what a node reads: single parts and ranges of parts (vector, array, span), mixed.
template <class... Parts>
Reads reads(const Parts&... parts) {
  return {detail::joined(parts...)};
}

/// Declares what a node writes: single parts and ranges of parts (vector, array, span), mixed.
template <class... Parts>
Writes writes(const Parts&... parts) {
  return {detail::joined(parts...)};
}

}  // namespace spoke::graph
