#pragma once

// The command of the program `spoke-compare`.

#include "bench/programs/compare_arguments.h"
#include "program/cli/arguments.h"

namespace spoke::cli {

/// Compares ways to run a scenario's step, prints tables and a conclusion and writes its files.
/// Returns the exit status. Throws InputError and DivergenceError, having written nothing.
int compare(const Arguments& arguments, const CompareArguments& own);

}  // namespace spoke::cli
