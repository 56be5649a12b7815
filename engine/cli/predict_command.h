#pragma once

// The command `spoke predict`.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Predicts what a scenario's step takes on any number of threads, measures it on those at hand,
/// prints a table and a conclusion and writes its files. Throws InputError and DivergenceError,
/// having written nothing. The exit status.
int predict(const Arguments& arguments);

}  // namespace spoke::cli
