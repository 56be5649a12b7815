#pragma once

// The command of the program `spoke-reproduce`.

#include "program/cli/arguments.h"

namespace spoke::cli {

/// What it asks for besides Arguments.
struct ReproduceArguments {
  bool quick = false;  ///< few rounds
};

/// Repeats the paper's evaluation, prints a table and writes reproduce.html and reproduce.json.
/// Returns the exit status. Throws InputError, having written nothing.
int reproduce(const Arguments& arguments, const ReproduceArguments& own);

}  // namespace spoke::cli
