#pragma once

// Memory of the machine, and what of it this process may use.

#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>

namespace spoke {

/// Returns the machine's memory [bytes]; 0 if not known.
std::int64_t physical_memory();

/// Returns the memory that this process may use [bytes]: the machine's, or the rest that its
/// control groups grant. Infinite if not known.
double available_memory();

/// Returns the memory that Linux control groups (versions 1 and 2) grant this process [bytes], or
/// nothing if they set no limit. `membership` and `root` are as for graph::cgroup_processors.
std::optional<double> cgroup_memory(std::istream& membership, const std::filesystem::path& root);

}  // namespace spoke
