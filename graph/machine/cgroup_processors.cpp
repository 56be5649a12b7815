// Reads the quotas of processor time.

#include "graph/machine/cgroup_processors.h"

#include <fstream>
#include <string>

#include "graph/machine/control_groups.h"

namespace spoke::graph {
namespace {

namespace fs = std::filesystem;

std::optional<double> ratio_of(std::optional<double> quota, std::optional<double> period) {
  if (!quota || !period || *quota <= 0.0 || *period <= 0.0) return std::nullopt;
  return *quota / *period;
}

std::optional<double> limit_of_v2(const fs::path& group) {
  std::string quota;
  std::string period;
  std::ifstream(group / "cpu.max") >> quota >> period;
  return ratio_of(parse_group_number(quota), parse_group_number(period));
}

std::optional<double> limit_of_v1(const fs::path& group) {
  return ratio_of(read_group_number(group / "cpu.cfs_quota_us"),
                  read_group_number(group / "cpu.cfs_period_us"));
}

}  // namespace

std::optional<double> cgroup_processors(std::istream& membership, const fs::path& root) {
  return smallest_group_limit(membership, root, {"cpu", limit_of_v1, limit_of_v2});
}

}  // namespace spoke::graph
