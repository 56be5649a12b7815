#pragma once

// Markup of views that engine/report/scene_view.js draws. Names of elements begin with that of
// their page.

#include <string>
#include <string_view>

namespace spoke::report {

/// The canvas PAGE-VIEW; `label`: what is seen, for who does not see it.
std::string scene_canvas(std::string_view page, std::string_view view, std::string_view label);

/// Room for buttons that look from fixed directions, PAGE-looks; and what moves the view,
/// PAGE-keys, after what `hint` says.
std::string scene_controls(std::string_view page, std::string_view hint = {});

}  // namespace spoke::report
