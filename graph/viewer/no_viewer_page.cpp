// The page of traces in builds without esbuild: none.

#include "graph/viewer/viewer_page.h"

namespace spoke::graph {

std::string_view viewer_page() { return {}; }

}  // namespace spoke::graph
