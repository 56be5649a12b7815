#pragma once

// What documents and help say of a key, besides its meaning.

#include <string>
#include <string_view>

#include "models/support/key_row.h"

namespace spoke::keys {

/// Returns a unit as documents write it: "kg m²"; empty: there is none.
std::string unit_of(const Row& row);
/// Returns what stands where a file gives nothing, in Markdown: "required", "0.5", "`[0, 0, 1]`".
std::string default_text_of(const Row& row);
/// Returns the range: "0 to 1", "greater than 0"; empty: any.
std::string range_text_of(const Row& row);

/// Returns a text in Markdown without links, as editors show it.
std::string without_links(std::string_view markdown);

}  // namespace spoke::keys
