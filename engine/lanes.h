#pragma once

// Loops over flex vectors take two neighbouring values at a time, in one vector register. GCC's and
// clang's vector types make sure of it where an array of two would leave it to the optimiser.

namespace spoke {

/// Two values side by side; arithmetic is by value, also with a double.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

namespace detail {
// Of an alias, clang takes alignment from behind its name only.
using PairInMemory __attribute__((may_alias)) = Pair;
using PairAnywhere __attribute__((may_alias, aligned(sizeof(double)))) = Pair;
static_assert(alignof(PairAnywhere) == sizeof(double));
}  // namespace detail

inline Pair both(double value) { return Pair{value, value}; }

/// Two neighbours from anywhere, and from a place aligned to their size (constants, and even places
/// of flex vectors).
inline Pair load(const double* x) { return *reinterpret_cast<const detail::PairAnywhere*>(x); }
inline Pair load_aligned(const double* x) {
  return *reinterpret_cast<const detail::PairInMemory*>(x);
}
inline void store(Pair value, double* x) { *reinterpret_cast<detail::PairInMemory*>(x) = value; }

inline double total(Pair value) { return value[0] + value[1]; }

}  // namespace spoke
