#pragma once

// The command `spoke static`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Finds the equilibrium of a scenario's model, prints it and writes its files. Throws InputError
/// and DivergenceError. The exit status.
int find_static(const Arguments& arguments);

}  // namespace spoke::cli
