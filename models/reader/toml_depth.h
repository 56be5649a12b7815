#pragma once

// A guard against TOML texts that nest without end.

#include <cstddef>
#include <optional>
#include <string_view>

namespace spoke {

/// Returns where a TOML text has a dotted key of more than `most` names (byte offset), if it has
/// one. The parser nests one table per name, without a limit of its own, and destroys them
/// recursively.
std::optional<std::size_t> find_deep_key(std::string_view text, std::size_t most);

}  // namespace spoke
