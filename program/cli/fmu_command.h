#pragma once

// The command of the program `spoke-fmu`.

#include <string>
#include <vector>

#include "program/cli/arguments.h"

namespace spoke::cli {

/// Options of the command besides Arguments, whose `out` is the FMU.
struct FmuArguments {
  std::vector<std::string> inputs, outputs;  ///< names
  int version = 3;                           ///< of FMI: 2 or 3
};

/// Makes an FMU of a scenario, and writes it. Throws InputError.
int make_fmu(const Arguments& arguments, const FmuArguments& own);

}  // namespace spoke::cli
