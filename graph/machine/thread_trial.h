#pragma once

// Whether the system lets this process have so many threads.

#include <cstddef>

namespace spoke::graph {

/// Makes threads until there are `threads`, the calling one included, and ends them: what a runtime
/// would not survive shows here. Throws InputError, with what the system says, if it refuses one.
/// stack: of each [bytes]; 0: the system's usual one.
void try_threads(int threads, std::size_t stack = 0);

}  // namespace spoke::graph
