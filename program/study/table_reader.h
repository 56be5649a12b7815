#pragma once

// Reads the CSV file of a design of the kind "table".

#include <string>
#include <vector>

#include "program/study/study.h"

namespace spoke::study {

/// Returns the columns of a CSV text as parameters: heads are keys of the scenario, and the cells
/// of a column are all numbers or all texts, some of them empty. Cells may stand in double quotes.
/// Messages name `file`. Throws InputError, "file:line:column: ...".
std::vector<Parameter> read_table(const std::string& text, const std::string& file);

}  // namespace spoke::study
