// Escapes text for HTML, and formats numbers.

#include "program/report/markup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace spoke::report {
namespace {

std::string print(int decimals, double value) {
  std::array<char, 400> text;  // the largest double has 309 digits before its decimals
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string without_trailing_zeros(std::string number) {
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
  }
  return number == "-0" ? "0" : number;
}

}  // namespace

std::string escape(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '"') {
      safe += "&quot;";
    } else if (c == '\'') {
      safe += "&#39;";
    } else {
      safe += (code < 0x20 && c != '\n' && c != '\t') || code == 0x7F ? ' ' : c;
    }
  }
  return safe;
}

std::string coordinate(double value) { return without_trailing_zeros(print(2, value)); }

std::string ratio_text(double ratio) {
  const bool is_small = ratio != 0.0 && std::abs(ratio) < 0.1;
  return is_small ? figure(ratio, 2) : std::isfinite(ratio) ? print(2, ratio) : figure(ratio);
}

std::string figure(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "-" : value > 0.0 ? "inf" : "-inf";
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size < 1e-4 || size >= 1e7) {
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return text.data();
  }
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  return print(std::max(0, digits - before), value);
}

std::string quantity(double value, const std::string& unit, int digits) {
  constexpr std::array prefixes = {"p", "n", "\u00b5", "m", "", "k", "M", "G", "T"};
  constexpr int none = 4;
  int place = none;
  // The digits are those of the rounded value: 999.96 has as many digits as 1000.
  const double size = std::abs(value) * (1.0 + 0.5 * std::pow(10.0, -digits));
  if (std::isfinite(value) && value != 0.0)
    place = none + static_cast<int>(std::floor(std::log10(size) / 3.0));
  if (place < 0 || place >= static_cast<int>(prefixes.size())) place = none;
  return figure(value * std::pow(10.0, 3 * (none - place)), digits) + ' ' +
         prefixes[static_cast<std::size_t>(place)] + unit;
}

}  // namespace spoke::report
