#pragma once

// The script of study.html, which the build embeds.

#include <string_view>

namespace spoke::report {

/// Returns the script of the page of a study: parallel coordinates, a scatter plot, and the run
/// that was chosen, by brushes that all share.
std::string_view study_script();

}  // namespace spoke::report
