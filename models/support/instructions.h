#pragma once

// The instructions that the arithmetic of this process uses: they decide the last bits of results.

#include <string_view>

// Sanitizers see into calls, not into what `flatten` makes of them; SPOKE_NATIVE compiles all code
// for the processor already.
#if defined(__x86_64__) && !defined(SPOKE_NATIVE) && !defined(SPOKE_SANITIZED)
#define SPOKE_WIDE_KERNELS 1
#else
#define SPOKE_WIDE_KERNELS 0
#endif

namespace spoke {

/// The variable of the environment by which a process computes with the instructions that all
/// processors of an architecture have.
///
/// Most of Spoke's own code is compiled for these, unless with SPOKE_NATIVE. Kernels of a step
/// (wide_kernels.h) and the elementary functions of the C library (sin, cos, exp) choose theirs
/// when the program starts: where the processor has fused multiply-add, results differ in the last
/// bits. The variable kTunables of the environment with kWithoutFusing forbids it to both.
inline constexpr const char* kTunables = "GLIBC_TUNABLES";
inline constexpr std::string_view kWithoutFusing = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4";

/// Returns "baseline": the same bits on every machine of this architecture; "avx2": kernels use
/// AVX2 and fused multiply-add, as do the C library's functions; "avx512": kernels use AVX-512
/// besides; "fma": the C library's functions alone; "native": Spoke was built for one processor.
std::string_view instructions_in_use();

/// The versions of kernels, each for the instructions of the one before and more.
enum class Kernels {
  baseline,  ///< for all processors of the architecture
  avx2,      ///< for AVX2 and fused multiply-add
  avx512,    ///< for AVX-512 (F, VL, DQ, BW)
};

/// Returns "baseline", ...
std::string_view name_of(Kernels kernels);

namespace detail {
extern Kernels kernels;  // set before main()
}

/// Returns the version that runs in this process: the last that the processor, the environment and
/// the build allow.
inline Kernels kernels_in_use() noexcept { return detail::kernels; }

/// Uses another version from here on, or the last one before it that the processor and the build
/// have, and returns the one that was in use. Not while anything is simulated.
Kernels use_kernels(Kernels kernels) noexcept;

}  // namespace spoke
