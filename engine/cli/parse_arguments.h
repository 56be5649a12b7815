#pragma once

// From the words of a command line to Arguments.

#include <string>
#include <vector>

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Parses the arguments behind the program's name. Throws InputError.
Arguments parse_arguments(const std::vector<std::string>& arguments);

}  // namespace spoke::cli
