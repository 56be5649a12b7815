#pragma once

// The command `spoke linearize`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Linearises a scenario's model, prints its size and writes its matrices. Throws InputError and
/// DivergenceError. The exit status.
int linearize(const Arguments& arguments);

}  // namespace spoke::cli
