#pragma once

// Arrays of VTK files.

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "models/vectors.h"

namespace spoke::test {

/// Returns the numbers of an array of a file.
inline std::vector<double> numbers_of(const std::string& file, const std::string& name) {
  const std::size_t at = file.find("Name=\"" + name + "\"");
  REQUIRE(at != std::string::npos);
  const char* text = file.c_str() + file.find('\n', at);
  std::vector<double> numbers;
  for (char* end = nullptr;; text = end) {
    const double number = std::strtod(text, &end);
    if (end == text) return numbers;
    numbers.push_back(number);
  }
}

/// Returns its vectors.
inline std::vector<spatial::Vector> vectors_of(const std::string& file, const std::string& name) {
  const std::vector<double> numbers = numbers_of(file, name);
  std::vector<spatial::Vector> vectors;
  for (std::size_t k = 0; k < numbers.size(); k += 3)
    vectors.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
  return vectors;
}

}  // namespace spoke::test
