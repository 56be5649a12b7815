#pragma once

// A number of a file, and how numbers are written.

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <string>

namespace spoke::foreign {

/// A number and where it came from: "HubRad, turbine.dat:46".
struct Value {
  double number = 0.0;
  std::string from;
};

/// Returns the shortest digits that give the same number. What scenarios refuse as too small is 0.
inline std::string digits(double number) {
  constexpr double least = 1e-40;
  return std::abs(number) < least ? "0" : fmt::format("{}", number);
}

}  // namespace spoke::foreign
