// Stands for the page of traces in builds without esbuild: there is none.

#include "program/viewer/viewer_page.h"

namespace spoke {

std::string_view viewer_page() { return {}; }

}  // namespace spoke
