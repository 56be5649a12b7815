#pragma once

// What `spoke help KEY` says of a key of a scenario.

#include <string>
#include <string_view>

namespace spoke::keys {

/// Returns for each key of this name its table, meaning, unit, default and range, as plain text;
/// for a table its keys. `name`: a path as `--set` has it, "blade.joint.stiffness",
/// "load.2.force", or its end, "stiffness"; brackets of a table may be there. Empty: there is no
/// such key.
std::string explain(std::string_view name);

/// Returns the name of a key that is spelled most alike; empty: none is alike.
std::string find_alike(std::string_view name);

}  // namespace spoke::keys
