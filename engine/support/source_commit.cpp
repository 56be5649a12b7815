// Compiled by itself: of all sources this alone changes with each commit.

#include "engine/support/source_commit.h"

namespace spoke {

std::string_view source_commit() { return SPOKE_COMMIT; }

}  // namespace spoke
