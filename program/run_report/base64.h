#pragma once

// Numbers as text, for the data in a page.

#include <cstdint>
#include <span>
#include <string>

namespace spoke::run_report {

/// Returns base64 of the numbers' bytes, the least significant first, as scripts of pages decode
/// them.
std::string encode(std::span<const float> numbers);
std::string encode(std::span<const std::int16_t> numbers);

}  // namespace spoke::run_report
