#pragma once

// Declarations of the parts that a node reads and writes.

#include <compare>
#include <cstddef>
#include <ranges>
#include <span>
#include <type_traits>
#include <vector>

namespace spoke::graph {

/// Handle of one part of the step's data, given out by StepGraphBuilder::add_part().
struct PartId {
  int index = -1;  ///< place in the order of addition
  /// Orders handles by index.
  friend auto operator<=>(const PartId&, const PartId&) = default;
};

/// The parts a node reads. reads() makes it.
struct Reads {
  std::vector<PartId> parts;  ///< in any order
};

/// The parts a node writes. writes() makes it. A part that is only written must be written in full.
struct Writes {
  std::vector<PartId> parts;  ///< in any order
};

/// The parts a node updates in place: it reads and writes them. updates() makes it.
struct Updates {
  std::vector<PartId> parts;  ///< in any order
};

/// Returns a part of which some models have none: the list of it, or an empty one if its handle is
/// invalid. Without this an invalid handle is refused, so that one that is forgotten is no missing
/// edge.
inline std::vector<PartId> maybe(PartId part) {
  return part.index < 0 ? std::vector<PartId>{} : std::vector<PartId>{part};
}

namespace detail {

/// A template, so that compilers look into it only where it is used.
template <class Parts>
void append(std::vector<PartId>& list, const Parts& parts) {
  if constexpr (std::is_same_v<Parts, PartId>) {
    list.push_back(parts);
  } else {
    for (const PartId part : parts) list.push_back(part);
  }
}

}  // namespace detail

/// Adds single parts and ranges of parts (vector, array, span), mixed, to a list.
template <class... Parts>
void add_to(std::vector<PartId>& list, const Parts&... parts) {
  (detail::append(list, parts), ...);
}

namespace detail {

template <class... Parts>
std::vector<PartId> joined(const Parts&... parts) {
  std::vector<PartId> list;
  add_to(list, parts...);
  return list;
}

}  // namespace detail

/// Declares the parts that a node reads: single parts and ranges of parts (vector, array, span),
/// mixed.
template <class... Parts>
Reads reads(const Parts&... parts) {
  return {detail::joined(parts...)};
}

/// Declares the parts that a node writes: single parts and ranges of parts (vector, array, span),
/// mixed.
template <class... Parts>
Writes writes(const Parts&... parts) {
  return {detail::joined(parts...)};
}

/// Declares the parts that a node updates in place: single parts and ranges of parts (vector,
/// array, span), mixed.
template <class... Parts>
Updates updates(const Parts&... parts) {
  return {detail::joined(parts...)};
}

/// Returns the memory of `count` objects in a row, as a range of a part. Any bits must be a valid
/// value, since check_declarations() overwrites data that a node must not read: numbers and
/// enumerations, but no bool and no pointer that is followed.
template <class T>
std::span<std::byte> bytes_of(T& first, std::size_t count) {
  return {reinterpret_cast<std::byte*>(&first), count * sizeof(T)};
}
/// Returns the memory of the elements of a range (array, vector, span), or of one object.
template <class Data>
std::span<std::byte> bytes_of(Data&& data) {
  if constexpr (std::ranges::contiguous_range<Data>) {
    auto* first = std::ranges::data(data);
    return {reinterpret_cast<std::byte*>(first), std::ranges::size(data) * sizeof(*first)};
  } else {
    static_assert(std::is_lvalue_reference_v<Data>, "the data must outlive the graph");
    static_assert(std::is_trivially_destructible_v<std::remove_reference_t<Data>>,
                  "a part holds plain data");
    return {reinterpret_cast<std::byte*>(&data), sizeof(data)};
  }
}

}  // namespace spoke::graph
