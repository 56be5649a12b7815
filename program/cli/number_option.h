#pragma once

// Numbers as values of options.

#include <string>

namespace spoke::cli {

/// Returns the whole text as a number from `least` to `most`. Throws CLI::ValidationError of the
/// option, "expected EXPECTED, got TEXT", if it is outside, no number, or nan.
double parse_number(const std::string& option, const std::string& text, double least, double most,
                    const std::string& expected);

}  // namespace spoke::cli
