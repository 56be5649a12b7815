#pragma once

// The command `spoke check`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Prints what a scenario's model is and how it vibrates. Throws InputError. The exit status.
int check(const Arguments& arguments);

}  // namespace spoke::cli
