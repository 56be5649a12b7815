#pragma once

// Reads the CSV file of a design of the kind "table".

#include <string>
#include <vector>

#include "engine/study/study.h"

namespace spoke::study {

/// The columns of a CSV text as parameters: heads are keys of the scenario, cells numbers, or texts
/// in all rows of a column. Cells may stand in double quotes. `file` stands in messages. Throws
/// InputError, "file:line:column: ...".
std::vector<Parameter> read_table(const std::string& text, const std::string& file);

}  // namespace spoke::study
