#pragma once

// Suggests names for misspelt ones.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spoke {

/// Returns the smallest number of letters inserted, deleted, replaced or swapped with their
/// neighbour that turns `a` into `b`.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the name a user most likely meant by `typed`; none if all are too far from it.
std::optional<std::string_view> nearest_name(std::string_view typed,
                                             std::span<const std::string_view> names);

/// Returns "is \"NAME\", expected ...", with the nearest of the existing names, of which there are
/// some.
std::string describe_unknown(const std::string& name, std::span<const std::string_view> names);

}  // namespace spoke
