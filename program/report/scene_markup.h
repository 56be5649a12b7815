#pragma once

// Markup of views that program/report/scene_view.js draws. Names of elements begin with that of
// their page.

#include <string>
#include <string_view>

namespace spoke::report {

/// Returns the canvas PAGE-VIEW; `label` describes the picture for readers who do not see it.
std::string scene_canvas(std::string_view page, std::string_view view, std::string_view label);

/// Returns room for buttons that look from fixed directions, PAGE-looks, and the keys that move the
/// view, PAGE-keys, after the text `hint`.
std::string scene_controls(std::string_view page, std::string_view hint = {});

}  // namespace spoke::report
