#pragma once

// What instructions the arithmetic of this process uses: they decide the last bits of results.

#include <string_view>

namespace spoke {

/// What a process may have to do to compute with the instructions that all processors of an
/// architecture have.
///
/// Spoke's own code is compiled for these, unless with SPOKE_NATIVE. The elementary functions of
/// the C library (sin, cos, exp) choose theirs when the program starts: where the processor has
/// fused multiply-add, some results differ in the last bit. The variable kTunables of the
/// environment with kWithoutFusing forbids it.
inline constexpr const char* kTunables = "GLIBC_TUNABLES";
inline constexpr std::string_view kWithoutFusing = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4";

/// "baseline": the same bits on every machine of this architecture; "fma": the C library's
/// functions use fused multiply-add; "native": Spoke was built for one processor.
std::string_view instructions_in_use();

}  // namespace spoke
