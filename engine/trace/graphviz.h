#pragma once

// Pictures by Graphviz.

#include <filesystem>
#include <string>

namespace spoke::trace {

/// Lets Graphviz draw the graph in `dot` as `svg`, whole or not at all. What went wrong, in words:
/// not installed, too slow, failed; empty: nothing.
std::string draw(const std::filesystem::path& dot, const std::filesystem::path& svg);

}  // namespace spoke::trace
