#pragma once

#include <string>
#include <vector>

#include "tests/program/cli/program.h"

/// Checks that spoke ends with status 2, one line on stderr that contains `message`, nothing on
/// stdout and nothing new in the folder. `before` as of run_spoke().
void check_refused(const std::vector<std::string>& arguments, const std::string& message,
                   const WorkFolder& folder, const std::string& before = "");
/// Checks as above in an empty folder.
void check_refused(const std::vector<std::string>& arguments, const std::string& message);
