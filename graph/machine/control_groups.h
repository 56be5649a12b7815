#pragma once

// Limits of Linux control groups, for processors and memory.

#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <string_view>

namespace spoke::graph {

/// Returns the limit of one group, read from the files in its folder; none if it sets no limit.
using GroupLimit = std::function<std::optional<double>(const std::filesystem::path& group)>;

/// The limit of one resource in the two versions of Linux control groups.
struct GroupResource {
  std::string_view controller;  ///< controller of version 1, e.g. "cpu"
  GroupLimit version_1;
  GroupLimit version_2;
};

/// Returns the smallest limit of a resource that a process's control groups set; none if they set
/// none. `membership` is text as in /proc/self/cgroup, `root` the folder where the groups are
/// mounted, /sys/fs/cgroup. Files that cannot be read set no limit.
std::optional<double> smallest_group_limit(std::istream& membership,
                                           const std::filesystem::path& root,
                                           const GroupResource& resource);

/// Returns the number that `text` begins with; none for "max", the word for no limit.
std::optional<double> parse_group_number(std::string_view text);

/// Returns the number that a group's file begins with.
std::optional<double> read_group_number(const std::filesystem::path& file);

}  // namespace spoke::graph
