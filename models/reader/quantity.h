#pragma once

// What numbers of a scenario must be, wherever they come from.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace spoke {

/// A number as a person would write it, in as many digits as it needs.
std::string describe(double number);

/// " (m)"; nothing if there is no unit.
std::string in_parentheses(std::string_view unit);

/// What a number must be: finite, within a range, and of a size that physics has.
struct Quantity {
  std::string_view unit;  ///< empty: dimensionless
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool least_included = true;

  static constexpr Quantity any(std::string_view unit) { return {unit}; }
  static constexpr Quantity positive(std::string_view unit) {
    return {unit, 0.0, std::numeric_limits<double>::infinity(), false};
  }
  static constexpr Quantity not_negative(std::string_view unit) { return {unit, 0.0}; }
  static constexpr Quantity between(double least, double greatest) { return {"", least, greatest}; }

  /// "a number greater than 0 (m)".
  std::string expectation() const;
  /// What is expected instead of `value`; empty if it may be.
  std::string expectation_instead_of(double value) const;

 private:
  bool holds(double value) const;
};

/// What a whole number must be.
struct Count {
  int least = 0;
  int greatest = 0;

  bool holds(std::int64_t value) const { return value >= least && value <= greatest; }
  /// "a whole number from 1 to 3".
  std::string expectation() const;
};

}  // namespace spoke
