#pragma once

// Counts and ranges of indices as people read them.

#include <cstdint>
#include <string>
#include <string_view>

namespace spoke {

/// Returns "1 step", "2 steps"; "1 body", "0 bodies"; "1 pass", "3 passes". The noun is in the
/// singular.
std::string counted(std::int64_t number, std::string_view noun);

/// Returns the whole numbers from first to last: "0 to 4", "1"; "none" if there are none.
std::string range_text(std::int64_t first, std::int64_t last);

}  // namespace spoke
