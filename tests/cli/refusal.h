#pragma once

#include <string>
#include <vector>

#include "tests/cli/program.h"

/// Checks that spoke ends with status 2, one line on stderr that contains `message`, nothing on
/// stdout and nothing new in the folder.
void check_refused(const std::vector<std::string>& arguments, const std::string& message,
                   const WorkFolder& folder);
/// The same in an empty folder.
void check_refused(const std::vector<std::string>& arguments, const std::string& message);
