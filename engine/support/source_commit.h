#pragma once

// Which commit of the sources the library was built from.

#include <string_view>

namespace spoke {

/// Returns the commit's first twelve digits, as of the newest configuration of the build; empty if
/// the sources were none of a repository. Changes that are not committed are not told.
std::string_view source_commit();

}  // namespace spoke
