#pragma once

// The command `spoke modes`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Finds the modes of a scenario's model, prints them and writes their files. Throws InputError and
/// DivergenceError. The exit status.
int find_modes(const Arguments& arguments);

}  // namespace spoke::cli
