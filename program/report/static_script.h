#pragma once

// The script of static.html, which the build embeds.

#include <string_view>

namespace spoke::report {

/// Returns the script of the page of an equilibrium: a view of the scene with its deflections.
std::string_view static_script();

}  // namespace spoke::report
