#pragma once

// Whole runs of the program spoke, as a user starts them.

#include <string>
#include <vector>

namespace spoke::bench {

/// Runs the program with these arguments, and discards its output. Returns the wall time from start
/// to end [s]. Throws std::runtime_error if it cannot be started or fails.
double seconds_of_process(const std::vector<std::string>& arguments);

}  // namespace spoke::bench
