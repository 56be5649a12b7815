#pragma once

// Loops over flex vectors take two neighbouring values at a time, in one vector register. GCC's and
// clang's vector types make sure of it where an array of two would leave it to the optimiser.

namespace spoke {

/// Two doubles side by side; arithmetic is by element, also with a double.
using Double2 = double __attribute__((vector_size(2 * sizeof(double))));

namespace detail {
// Of an alias, clang takes alignment from behind its name only.
using Double2Aligned __attribute__((may_alias)) = Double2;
using Double2Unaligned __attribute__((may_alias, aligned(sizeof(double)))) = Double2;
static_assert(alignof(Double2Unaligned) == sizeof(double));
}  // namespace detail

/// The same value twice.
inline Double2 broadcast(double value) { return Double2{value, value}; }

/// Two neighbours from anywhere, and from an address aligned to their size (constants, and even
/// indices of flex vectors).
inline Double2 load(const double* x) {
  return *reinterpret_cast<const detail::Double2Unaligned*>(x);
}
inline Double2 load_aligned(const double* x) {
  return *reinterpret_cast<const detail::Double2Aligned*>(x);
}
inline void store(Double2 value, double* x) {
  *reinterpret_cast<detail::Double2Unaligned*>(x) = value;
}
inline void store_aligned(Double2 value, double* x) {
  *reinterpret_cast<detail::Double2Aligned*>(x) = value;
}

/// The sum of both.
inline double total(Double2 value) { return value[0] + value[1]; }

}  // namespace spoke
