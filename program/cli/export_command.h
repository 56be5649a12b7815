#pragma once

// The command of the program `spoke-export`.

#include "program/cli/arguments.h"

namespace spoke::cli {

/// Options of the command besides Arguments, whose `out` is the first file.
struct ExportArguments {
  std::string format;  ///< "beamdyn", "elastodyn" or "aerodyn"
  int blade = 1;       ///< number of the blade
};

/// Writes a blade, and what belongs to it, of a scenario as files of another program. Throws
/// InputError.
int export_blade(const Arguments& arguments, const ExportArguments& own);

}  // namespace spoke::cli
