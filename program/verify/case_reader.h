#pragma once

// Reads files of cases (TOML).

#include <string>
#include <vector>

#include "program/verify/case.h"

namespace spoke::verify {

/// Reads the cases of a group from the text of a file; `name` stands for it in messages. Throws
/// InputError "file:line:column: key: what is wrong, what is expected".
std::vector<Case> read_cases(const std::string& text, const std::string& name);

}  // namespace spoke::verify
