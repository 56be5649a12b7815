#pragma once

// Numbers that callers of a simulation choose.

#include <cstdint>

namespace spoke {

/// Throws InputError unless least <= value <= greatest; `what` the value is.
void require_range(const char* what, std::int64_t value, std::int64_t least, std::int64_t greatest);

}  // namespace spoke
