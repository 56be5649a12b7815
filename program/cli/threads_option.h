#pragma once

// Numbers of threads on the command line.

#include <string>

#include "graph/executor.h"

namespace spoke::cli {

/// Parses "2", or "3x2" for nested teams. Throws InputError that says what was expected and what
/// was given.
graph::Threads parse_threads(const std::string& text);

/// Parses the value of the option --threads, which its errors name. Throws CLI::ValidationError,
/// which run_program() turns into an InputError.
graph::Threads parse_threads_option(const std::string& text);

}  // namespace spoke::cli
