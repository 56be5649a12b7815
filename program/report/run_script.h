#pragma once

// The script of report.html, which the build embeds.

#include <string_view>

namespace spoke::report {

/// Returns the script of the page of a run: views of scenes, animations, plots over time and
/// run_page.js, which the build puts into the library (CMakeLists.txt).
std::string_view run_script();

}  // namespace spoke::report
