// Parses numbers; text behind a number is an error.

#include "program/cli/number_option.h"

#include <CLI/CLI.hpp>
#include <cstdlib>

namespace spoke::cli {

double parse_number(const std::string& option, const std::string& text, double least, double most,
                    const std::string& expected) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_number = !text.empty() && end == text.c_str() + text.size();
  if (!is_number || !(value >= least && value <= most))  // false for nan
    throw CLI::ValidationError(option, "expected " + expected + ", got " + text);
  return value;
}

}  // namespace spoke::cli
