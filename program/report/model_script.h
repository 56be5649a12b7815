#pragma once

// The script of the page of a model, which the build embeds.

#include <string_view>

namespace spoke::report {

/// Returns the script of the page that `spoke check` writes: the views of scenes and model_page.js.
std::string_view model_script();

}  // namespace spoke::report
