#pragma once

// The command `spoke compare`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Compares ways to run a scenario's step, prints tables and a conclusion and writes its files.
/// Throws InputError and DivergenceError, having written nothing. The exit status.
int compare(const Arguments& arguments);

}  // namespace spoke::cli
