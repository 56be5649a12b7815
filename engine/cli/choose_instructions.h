#pragma once

// `--instructions baseline`, `avx2`: the same bits on machines of different processors.

#include <string>

namespace spoke::cli {

/// "auto": what the process has chosen, or what the checkpoint `resumed` (empty: none) was computed
/// with, where that is possible; else it stays as it is, and resume() refuses it. "avx2": kernels
/// as on processors without AVX-512. "baseline": starts this program again, with the same arguments
/// and in an environment in which the C library uses baseline instructions only; returns if the
/// process computes with them already. Throws InputError in a program built with SPOKE_NATIVE,
/// where the processor or the program lacks the instructions, or if it cannot be started again.
void choose_instructions(const std::string& name, const std::string& resumed, char** arguments);

}  // namespace spoke::cli
