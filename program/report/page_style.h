#pragma once

// The style sheet of all pages.

#include <string_view>

namespace spoke::report {

/// Returns the style sheet of every page, and of the drawings in it.
std::string_view page_style();

}  // namespace spoke::report
