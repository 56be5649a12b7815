// Units are words with exponents; a stroke turns the sign of those behind it.

#include "program/fmu/unit.h"

#include <charconv>
#include <cstddef>
#include <utility>

namespace spoke::fmu {
namespace {

constexpr std::pair<std::string_view, Unit> kWords[] = {
    {"1", {{0, 0, 0, 0}}},   {"kg", {{1, 0, 0, 0}}},  {"m", {{0, 1, 0, 0}}},
    {"s", {{0, 0, 1, 0}}},   {"rad", {{0, 0, 0, 1}}}, {"N", {{1, 1, -2, 0}}},
    {"J", {{1, 2, -2, 0}}},  {"W", {{1, 2, -3, 0}}},  {"Pa", {{1, -1, -2, 0}}},
    {"Hz", {{0, 0, -1, 0}}},
};

const Unit* find(std::string_view word) {
  for (const auto& [name, unit] : kWords)
    if (name == word) return &unit;
  return nullptr;
}

/// Reads "m^2" as the unit "m" to the power of 2.
std::optional<Unit> parse_word(std::string_view word) {
  int power = 1;
  const std::size_t caret = word.find('^');
  if (caret != std::string_view::npos) {
    const char* end = word.data() + word.size();
    const auto read = std::from_chars(word.data() + caret + 1, end, power);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    word = word.substr(0, caret);
  }
  const Unit* known = find(word);
  if (!known) return std::nullopt;
  Unit unit = *known;
  for (int& exponent : unit.exponents) exponent *= power;
  return unit;
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  Unit product;
  int sign = 1;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of(" /"), text.size());
    if (length > 0) {
      const std::optional<Unit> unit = parse_word(text.substr(0, length));
      if (!unit) return std::nullopt;
      for (std::size_t k = 0; k < kBaseUnits.size(); ++k)
        product.exponents[k] += sign * unit->exponents[k];
    }
    if (length < text.size() && text[length] == '/') sign = -1;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return product;
}

}  // namespace spoke::fmu
