#pragma once

// `--instructions baseline`: the same bits on every machine of an architecture.

namespace spoke::cli {

/// Starts this program again, with the same arguments and in an environment in which the C library
/// uses baseline instructions only; returns if the process computes with them already.
/// Throws InputError in a program built with SPOKE_NATIVE, or if it cannot be started again.
void use_baseline_instructions(char** arguments);

}  // namespace spoke::cli
