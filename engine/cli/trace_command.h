#pragma once

// The command `spoke trace`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Runs to a time, records the steps that follow, node by node, writes the files and prints a
/// summary. If the simulation diverges meanwhile, of the steps before. Throws InputError, and
/// DivergenceError if there are none, having written nothing. The exit status.
int trace(const Arguments& arguments);

}  // namespace spoke::cli
