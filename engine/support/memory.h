#pragma once

// How much memory there is.

#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>

namespace spoke {

/// The machine's memory [bytes]; 0 if not known.
std::int64_t physical_memory();

/// The memory that this process may use [bytes]: the machine's, or what its control groups leave
/// of it. Infinite if not known.
double available_memory();

/// The memory that Linux control groups (versions 1 and 2) grant this process [bytes], or nothing
/// if they set no limit. `membership` and `root` as for graph::cgroup_processors.
std::optional<double> cgroup_memory(std::istream& membership, const std::filesystem::path& root);

}  // namespace spoke
