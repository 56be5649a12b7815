#pragma once

// Numbers of threads on the command line.

#include <string>

#include "graph/executor.h"

namespace spoke::cli {

/// "2", or "3x2" of nested teams. Throws InputError, its text what was expected and what was given.
graph::Threads parse_threads(const std::string& text);

/// The same as the value of the option --threads, which it names. Throws as options do, which
/// run_program() turns into an InputError.
graph::Threads parse_threads_option(const std::string& text);

}  // namespace spoke::cli
