#pragma once

// The command `spoke reproduce`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Repeats the paper's evaluation, prints a table and writes reproduce.html and reproduce.json.
/// Throws InputError, having written nothing. The exit status.
int reproduce(const Arguments& arguments);

}  // namespace spoke::cli
