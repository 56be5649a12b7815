// Makes canvases with roles and labels, and their keys.

#include "program/report/scene_markup.h"

#include <spdlog/fmt/fmt.h>

namespace spoke::report {

std::string scene_canvas(std::string_view page, std::string_view view, std::string_view label) {
  return fmt::format(
      R"(<canvas id="{0}-{1}" tabindex="0" role="application" aria-roledescription="3-D view" aria-label="{2}" aria-describedby="{0}-keys"></canvas>)",
      page, view, label);
}

std::string scene_controls(std::string_view page, std::string_view hint) {
  return fmt::format(
      R"(<span id="{0}-looks" class="looks" role="group" aria-label="Direction of view"></span>
<span class="hint" id="{0}-keys">{1}Drag to turn, with shift to move, scroll or pinch to zoom, double-click to reset. With the keyboard: arrows turn, with shift they move, + and &#8722; zoom, 0 resets.</span>
)",
      page, hint);
}

}  // namespace spoke::report
