#pragma once

// Ranges of the numbers of a scenario, wherever they come from.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace spoke {

/// Returns a number as a person would write it, in as many digits as it needs.
std::string describe(double number);

/// Returns " (m)"; empty if there is no unit.
std::string in_parentheses(std::string_view unit);

/// The range of a number: finite, within bounds, and of a size that physics has.
struct Quantity {
  std::string_view unit;  ///< empty: dimensionless
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool least_included = true;
  bool greatest_included = true;

  static constexpr Quantity any(std::string_view unit) { return {unit}; }
  static constexpr Quantity positive(std::string_view unit) {
    return {unit, 0.0, std::numeric_limits<double>::infinity(), false};
  }
  static constexpr Quantity not_negative(std::string_view unit) { return {unit, 0.0}; }
  static constexpr Quantity between(double least, double greatest) { return {"", least, greatest}; }
  static constexpr Quantity inside(double least, double greatest) {
    return {"", least, greatest, false, false};
  }

  /// Returns "a number greater than 0 (m)".
  std::string expectation() const;
  /// Returns what is expected instead of `value`; empty if the value is allowed.
  std::string expectation_instead_of(double value) const;

 private:
  bool holds(double value) const;
};

/// The range of a whole number.
struct Count {
  int least = 0;
  int greatest = 0;

  bool holds(std::int64_t value) const { return value >= least && value <= greatest; }
  /// Returns "a whole number from 1 to 3".
  std::string expectation() const;
};

}  // namespace spoke
