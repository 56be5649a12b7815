#pragma once

// `--instructions baseline`, `avx2`: the same bits on machines of different processors.

#include <functional>
#include <string>

namespace spoke::cli {

/// Chooses by the option's value. "auto": the instructions that the process has chosen. A run or
/// study that is resumed goes on with those it was computed with (`before()`) if possible;
/// otherwise the checkpoint or journal is refused later. "avx2": kernels as on processors without
/// AVX-512. "baseline": starts this program again, with the same words and in an environment in
/// which the C library uses baseline instructions only; returns if the process computes with them
/// already. Throws InputError in a program built with SPOKE_NATIVE, where processor, program or
/// environment lack the instructions, or if it cannot be started again.
void choose_instructions(const std::string& name, const std::function<std::string()>& before,
                         char** words);

}  // namespace spoke::cli
