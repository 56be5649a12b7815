#pragma once

// The processors that control groups leave to this process.

#include <filesystem>
#include <istream>
#include <optional>

namespace spoke::graph {

/// Returns how many processors Linux control groups (versions 1 and 2) grant this process, none if
/// they set no limit. `membership` is text as in /proc/self/cgroup, `root` the folder where the
/// groups are mounted, /sys/fs/cgroup. Files that cannot be read set no limit.
std::optional<double> cgroup_processors(std::istream& membership,
                                        const std::filesystem::path& root);

}  // namespace spoke::graph
