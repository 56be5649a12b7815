#pragma once

// The script of modes.html and campbell.html, which the build embeds.

#include <string_view>

namespace spoke::report {

/// Returns the script of the page of modes: their shapes in motion, and over several speeds the
/// Campbell diagram.
std::string_view modes_script();

}  // namespace spoke::report
