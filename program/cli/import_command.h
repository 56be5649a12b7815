#pragma once

// The command of the program `spoke-import`.

#include <optional>
#include <string>
#include <vector>

#include "program/cli/arguments.h"

namespace spoke::cli {

/// Options of the command besides Arguments, whose `out` is the scenario.
struct ImportArguments {
  std::vector<std::string> files;
  std::optional<double> length, height;  ///< of a blade, of a tower [m]
};

/// Makes a scenario of files of other programs, and writes it. Throws InputError.
int import_scenario(const Arguments& arguments, const ImportArguments& own);

}  // namespace spoke::cli
