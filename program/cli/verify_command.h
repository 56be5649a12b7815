#pragma once

// The command of the program `spoke-verify`.

#include <string>
#include <vector>

#include "program/cli/arguments.h"

namespace spoke::cli {

/// Options of the command besides Arguments.
struct VerifyArguments {
  std::vector<std::string> names;  ///< cases and groups; empty: all
  std::string folder;              ///< with the user's own cases; empty: the shipped ones
  bool lists = false;              ///< prints the names, and runs nothing
};

/// Runs cases whose results are known, and writes how far Spoke's are from them. Returns 3 if one
/// is not within its stated error. Throws InputError.
int verify(const Arguments& arguments, const VerifyArguments& own);

}  // namespace spoke::cli
