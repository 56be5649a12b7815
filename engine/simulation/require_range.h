#pragma once

// Checks the bounds of numbers that programs pass.

#include <cstdint>

namespace spoke {

/// Throws InputError "`what` is 7, expected 0 to 3" unless least <= value <= greatest.
void require_range(const char* what, std::int64_t value, std::int64_t least, std::int64_t greatest);

}  // namespace spoke
