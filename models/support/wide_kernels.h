#pragma once

// Kernels that are compiled three times: for the instructions that all processors of an
// architecture have, for AVX2 with fused multiply-add, and for AVX-512. Which ones run is decided
// when the process starts, for all of it (instructions.h): results depend on it in their last bits.
//
// The AVX-512 version uses its 32 registers and its masks, not the widest vectors: these sources
// are compiled for vectors of 256 bits (engine/CMakeLists.txt).

#include "models/support/instructions.h"

namespace spoke {

#if SPOKE_WIDE_KERNELS
#define SPOKE_AVX2 "avx2,fma"
#define SPOKE_AVX512 "avx2,fma,avx512f,avx512vl,avx512dq,avx512bw"

namespace detail {

/// Runs the kernel and all that it calls, as far as it is visible, as one function for these
/// instructions. Functions of the kernel's have one version each for the rest of the program: no
/// function with wide instructions is ever linked in place of another.
template <class Kernel>
[[gnu::target(SPOKE_AVX2), gnu::flatten, gnu::noinline]] auto run_avx2(
    const Kernel& kernel) noexcept {
  return kernel();
}
template <class Kernel>
[[gnu::target(SPOKE_AVX512), gnu::flatten, gnu::noinline]] auto run_avx512(
    const Kernel& kernel) noexcept {
  return kernel();
}

/// Runs it with a stack frame aligned to a cache line's half besides, which Clang gives to no
/// function by itself: of registers that do not fit into 16 and are kept there, every other one
/// would cross the end of a line, or not, by where main() happens to stand.
template <class Kernel>
[[gnu::target(SPOKE_AVX2), gnu::flatten, gnu::noinline, gnu::force_align_arg_pointer]] auto
run_avx2_aligned(const Kernel& kernel) noexcept {
  return kernel();
}
template <class Kernel>
[[gnu::target(SPOKE_AVX512), gnu::flatten, gnu::noinline, gnu::force_align_arg_pointer]] auto
run_avx512_aligned(const Kernel& kernel) noexcept {
  return kernel();
}

}  // namespace detail

#undef SPOKE_AVX2
#undef SPOKE_AVX512
#endif

/// Calls `kernel()`, with the instructions in use. Kernels may run within others.
template <class Kernel>
[[gnu::always_inline]] inline auto run_kernel(const Kernel& kernel) noexcept {
#if SPOKE_WIDE_KERNELS
  if (kernels_in_use() == Kernels::avx512) return detail::run_avx512(kernel);
  if (kernels_in_use() == Kernels::avx2) return detail::run_avx2(kernel);
#endif
  return kernel();
}

/// Calls kernels with more values at a time than registers.
template <class Kernel>
[[gnu::always_inline]] inline auto run_large_kernel(const Kernel& kernel) noexcept {
#if SPOKE_WIDE_KERNELS
  if (kernels_in_use() == Kernels::avx512) return detail::run_avx512_aligned(kernel);
  if (kernels_in_use() == Kernels::avx2) return detail::run_avx2_aligned(kernel);
#endif
  return kernel();
}

}  // namespace spoke
