#pragma once

// The command `spoke campbell`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Follows the modes of a scenario's model over speeds, prints them and their crossings with
/// multiples of the speed, and writes their files. Throws InputError and DivergenceError. The exit
/// status.
int find_campbell(const Arguments& arguments);

}  // namespace spoke::cli
