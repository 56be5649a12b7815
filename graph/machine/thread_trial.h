#pragma once

// Tries whether the system lets this process have so many threads.

#include <cstddef>

namespace spoke::graph {

/// Makes threads until there are `threads`, the calling one included, and ends them: so a refusal
/// that would end a runtime is found before. Throws InputError, with the system's message, if it
/// refuses one. stack: size of each thread's stack [bytes]; 0: the system's usual one.
void try_threads(int threads, std::size_t stack = 0);

}  // namespace spoke::graph
