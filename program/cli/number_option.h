#pragma once

// Numbers of options.

#include <string>

namespace spoke::cli {

/// The number that the whole text is, from `least` to `most`. Else throws CLI::ValidationError of
/// the option: "expected EXPECTED, got TEXT". A text that is no number, or nan, is none from
/// anything.
double parse_number(const std::string& option, const std::string& text, double least, double most,
                    const std::string& expected);

}  // namespace spoke::cli
