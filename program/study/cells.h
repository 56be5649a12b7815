#pragma once

// Numbers as cells of a study's CSV files.

#include <string>

namespace spoke::study {

/// Returns a number with all its digits; nothing for one that is not finite.
std::string number_cell(double value);

}  // namespace spoke::study
