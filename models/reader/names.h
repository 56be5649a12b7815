#pragma once

// Names that a scenario gives to what it describes, as they stand in the names of columns.

#include <string>

namespace spoke {

/// Whether a text may name a sensor, a joint, a body or a subsystem.
bool is_name(const std::string& text);

/// What is expected of one.
inline constexpr const char* kNameExpected =
    "letters, digits, \"_\", \"-\" and \".\", 1 to 64 of them";

}  // namespace spoke
