#pragma once

// Numbers of options. Includes CLI11, as who reads options does.

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>

namespace spoke::cli {

/// The number that the whole text is, from `least` to `most`. Else throws CLI::ValidationError of
/// the option: "expected EXPECTED, got TEXT". A text that is no number, or nan, is none from
/// anything.
inline double parse_number(const std::string& option, const std::string& text, double least,
                           double most, const std::string& expected) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_number = !text.empty() && end == text.c_str() + text.size();
  if (!is_number || !(value >= least && value <= most))  // nan is not
    throw CLI::ValidationError(option, "expected " + expected + ", got " + text);
  return value;
}

}  // namespace spoke::cli
