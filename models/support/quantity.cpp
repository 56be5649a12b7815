// Tests values against their range, and words what was expected.

#include "models/support/quantity.h"

#include <array>
#include <charconv>
#include <cmath>

namespace spoke {
namespace {

// Numbers outside are no physics, and their products would leave the range of a double.
constexpr double kSmallest = 1e-40;
constexpr double kLargest = 1e30;

bool is_sensible(double value) {
  return value == 0.0 || (std::abs(value) >= kSmallest && std::abs(value) <= kLargest);
}

}  // namespace

std::string describe(double number) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

std::string in_parentheses(std::string_view unit) {
  return unit.empty() ? "" : " (" + std::string(unit) + ')';
}

bool Quantity::holds(double value) const {
  return (least_included ? value >= least : value > least) &&
         (greatest_included ? value <= greatest : value < greatest);
}

std::string Quantity::expectation() const {
  std::string text = "a number";
  if (std::isfinite(least) && std::isfinite(greatest)) {
    text += (least_included ? " from " : " greater than ") + describe(least) +
            (!greatest_included ? " and less than "
             : least_included   ? " to "
                                : " and at most ") +
            describe(greatest);
  } else if (std::isfinite(least)) {
    text +=
        least_included ? " of " + describe(least) + " or more" : " greater than " + describe(least);
  }
  return text + in_parentheses(unit);
}

std::string Quantity::expectation_instead_of(double value) const {
  if (!std::isfinite(value)) return "a finite number" + in_parentheses(unit);
  if (!holds(value)) return expectation();
  if (is_sensible(value)) return {};
  return "0 or a magnitude from " + describe(kSmallest) + " to " + describe(kLargest) +
         in_parentheses(unit);
}

std::string Count::expectation() const {
  return "a whole number from " + std::to_string(least) + " to " + std::to_string(greatest);
}

}  // namespace spoke
