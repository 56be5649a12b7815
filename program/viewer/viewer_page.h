#pragma once

// The page of traces, which the build embeds.

#include <string_view>

namespace spoke {

/// Returns the page that shows a recorded trace, whole and self-contained, as HTML in UTF-8. It
/// contains once
///   <script type="application/json" id="spoke-trace">null</script>
/// where the trace's data take the place of `null`, with every "</" in them written as "<\/". Empty
/// if Spoke was built without esbuild (see program/viewer/CMakeLists.txt).
std::string_view viewer_page();

}  // namespace spoke
