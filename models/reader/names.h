#pragma once

// Names in a scenario, which become parts of the names of columns.

#include <string>

namespace spoke {

/// Whether a text may name a sensor, a joint, a body or a subsystem.
bool is_name(const std::string& text);

/// The words of messages for what is expected instead of a bad name.
inline constexpr const char* kNameExpected =
    "letters, digits, \"_\", \"-\" and \".\", 1 to 64 of them";

/// What a program's user calls gravity among the loads; no load has this name.
inline constexpr const char* kGravityName = "gravity";
/// Returns what is wrong with the name of a load; empty if nothing is, or if it has none.
std::string find_load_name_fault(const std::string& name);

}  // namespace spoke
