#pragma once

// Whether the system lets this process have so many threads.

namespace spoke::graph {

/// Makes threads until there are `threads`, the calling one included, and ends them: what a runtime
/// would not survive shows here. Throws InputError, with what the system says, if it refuses one.
void try_threads(int threads);

}  // namespace spoke::graph
