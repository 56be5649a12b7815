#pragma once

// Kernels that are compiled twice, for the instructions that all processors of an architecture have
// and for AVX2 with fused multiply-add. Which ones run is decided when the process starts, for all
// of it (instructions.h): results depend on it in their last bits.

#include "engine/support/instructions.h"

namespace spoke {

#if SPOKE_WIDE_KERNELS
namespace detail {

/// The kernel and all that it calls, as far as it is visible, as one function for these
/// instructions. Functions of the kernel's have one version each for the rest of the program: no
/// function with wide instructions is ever linked in place of another.
template <class Kernel>
[[gnu::target("avx2,fma"), gnu::flatten, gnu::noinline]] auto run_wide(
    const Kernel& kernel) noexcept {
  return kernel();
}

/// The same with a stack frame aligned to a cache line's half, which Clang gives to no function by
/// itself: of registers that do not fit into 16 and are kept there, every other one would cross the
/// end of a line, or not, by where main() happens to stand.
template <class Kernel>
[[gnu::target("avx2,fma"), gnu::flatten, gnu::noinline, gnu::force_align_arg_pointer]] auto
run_wide_aligned(const Kernel& kernel) noexcept {
  return kernel();
}

}  // namespace detail
#endif

/// Calls `kernel()`, of wide instructions where they are in use. Kernels may run within others.
template <class Kernel>
[[gnu::always_inline]] inline auto run_kernel(const Kernel& kernel) noexcept {
#if SPOKE_WIDE_KERNELS
  if (kernels_in_use() == Kernels::wide) return detail::run_wide(kernel);
#endif
  return kernel();
}

/// The same for kernels with more values at a time than registers.
template <class Kernel>
[[gnu::always_inline]] inline auto run_large_kernel(const Kernel& kernel) noexcept {
#if SPOKE_WIDE_KERNELS
  if (kernels_in_use() == Kernels::wide) return detail::run_wide_aligned(kernel);
#endif
  return kernel();
}

}  // namespace spoke
