#pragma once

// The command of the program `spoke-reproduce`.

#include "program/cli/arguments.h"

namespace spoke::cli {

/// Options of the command besides Arguments.
struct ReproduceArguments {
  bool quick = false;  ///< whether to measure few rounds
};

/// Repeats the paper's evaluation, prints a table and writes reproduce.html and reproduce.json.
/// Returns the exit status. Throws InputError, having written nothing.
int reproduce(const Arguments& arguments, const ReproduceArguments& own);

}  // namespace spoke::cli
