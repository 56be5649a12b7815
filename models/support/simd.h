#pragma once

#include <cassert>
#include <cstdint>

// Loops take two or four neighbouring values at a time, in a vector register. GCC's and clang's
// vector types ensure it; with arrays it would depend on the optimiser.

namespace spoke {

/// Two doubles side by side; arithmetic is by element, also with a double.
using Double2 = double __attribute__((vector_size(2 * sizeof(double))));
/// Four doubles: one register where kernels are compiled for AVX2, else two. How functions take and
/// return them depends on the instructions: pass them to functions that are always inlined only.
using Double4 = double __attribute__((vector_size(4 * sizeof(double))));

namespace detail {
// Clang takes the alignment of an alias only from behind its name.
using Double2Aligned __attribute__((may_alias)) = Double2;
using Double2Unaligned __attribute__((may_alias, aligned(sizeof(double)))) = Double2;
static_assert(alignof(Double2Unaligned) == sizeof(double));
using Double4Unaligned __attribute__((may_alias, aligned(sizeof(double)))) = Double4;
static_assert(alignof(Double4Unaligned) == sizeof(double));
}  // namespace detail

/// Returns the same value twice.
inline Double2 broadcast(double value) { return Double2{value, value}; }

/// Load two neighbours from any address, and from one aligned to their size (constants, and even
/// indices of flex vectors).
inline Double2 load(const double* x) {
  return *reinterpret_cast<const detail::Double2Unaligned*>(x);
}
/// Whether an address is aligned so.
inline bool is_aligned(const double* x) {
  return reinterpret_cast<std::uintptr_t>(x) % alignof(Double2) == 0;
}
inline Double2 load_aligned(const double* x) {
  assert(is_aligned(x));
  return *reinterpret_cast<const detail::Double2Aligned*>(x);
}
inline void store(Double2 value, double* x) {
  *reinterpret_cast<detail::Double2Unaligned*>(x) = value;
}
inline void store_aligned(Double2 value, double* x) {
  assert(is_aligned(x));
  *reinterpret_cast<detail::Double2Aligned*>(x) = value;
}

/// Returns the sum of both.
inline double total(Double2 value) { return value[0] + value[1]; }

/// Loads four neighbours from any address.
[[gnu::always_inline]] inline Double4 load4(const double* x) {
  return *reinterpret_cast<const detail::Double4Unaligned*>(x);
}
[[gnu::always_inline]] inline void store(const Double4& value, double* x) {
  *reinterpret_cast<detail::Double4Unaligned*>(x) = value;
}

}  // namespace spoke
