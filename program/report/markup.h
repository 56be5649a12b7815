#pragma once

// Letters of HTML and SVG: escaped text, and numbers as people read them.

#include <string>
#include <string_view>

namespace spoke::report {

/// Returns the text as content or attribute value of HTML and of XML: & < > " ' are escaped,
/// control characters other than line feeds and tabs become spaces.
std::string escape(std::string_view text);

/// Returns a coordinate or length of a drawing: two decimals at most, no exponent, no "-0".
std::string coordinate(double value);

/// Returns a number for people in `digits` significant digits: "1.84", "0.0213", "12300",
/// "4.1e-07".
std::string figure(double value, int digits = 3);

/// Returns a ratio of times: two decimals, or two digits of a small one, which is not 0.
std::string ratio_text(double ratio);
/// Returns a number with a unit behind it, which takes an SI prefix: "-5.611 MN m", "80.8 uJ" with
/// the Greek letter.
std::string quantity(double value, const std::string& unit, int digits = 3);

}  // namespace spoke::report
