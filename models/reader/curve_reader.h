#pragma once

// Reads curves that a file gives as two arrays.

#include <string_view>

#include "models/curve.h"
#include "models/reader/toml_section.h"

namespace spoke {

/// Returns the curve of the array `key` over the array `over`, which increases. Throws InputError
/// unless both are there and of one size.
Curve read_curve(const TomlSection& section, std::string_view over, const Quantity& over_quantity,
                 std::string_view key, const Quantity& quantity);

}  // namespace spoke
