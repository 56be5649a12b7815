// Reads memory and its limits from the system.

#include "engine/support/memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "graph/machine/control_groups.h"

namespace spoke {
namespace {

namespace fs = std::filesystem;

std::optional<double> limit_of_v2(const fs::path& group) {
  return graph::read_group_number(group / "memory.max");
}

/// Version 1 gives no limit as a number beyond all memory.
std::optional<double> limit_of_v1(const fs::path& group) {
  return graph::read_group_number(group / "memory.limit_in_bytes");
}

}  // namespace

std::int64_t physical_memory() {
  const std::int64_t pages = sysconf(_SC_PHYS_PAGES);
  const std::int64_t page_size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && page_size > 0 ? pages * page_size : 0;
}

double available_memory() {
  const std::int64_t physical = physical_memory();
  const double machine =
      physical > 0 ? static_cast<double>(physical) : std::numeric_limits<double>::infinity();
  std::ifstream membership("/proc/self/cgroup");
  return std::min(machine, cgroup_memory(membership, "/sys/fs/cgroup").value_or(machine));
}

std::optional<double> cgroup_memory(std::istream& membership, const fs::path& root) {
  return graph::smallest_group_limit(membership, root, {"memory", limit_of_v1, limit_of_v2});
}

}  // namespace spoke
