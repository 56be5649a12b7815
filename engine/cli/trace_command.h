#pragma once

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Runs to a time, records the steps that follow, node by node, writes the files and prints a
/// summary. Throws InputError and DivergenceError, having written nothing. The exit status.
int trace(const Arguments& arguments);

}  // namespace spoke::cli
