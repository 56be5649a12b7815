#pragma once

// The command `spoke run`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Simulates a scenario and writes its results. Throws InputError. The exit status: 0, or 3 if the
/// simulation diverged.
int run(const Arguments& arguments);

}  // namespace spoke::cli
