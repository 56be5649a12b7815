#include "graph/machine/cgroup_processors.h"

#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "tests/group_tree.h"

using spoke::test::GroupTree;

namespace {

std::optional<double> limit(const GroupTree& tree, const std::string& membership) {
  std::istringstream lines(membership);
  return spoke::graph::cgroup_processors(lines, tree.root());
}

}  // namespace

TEST_CASE("control groups, version 2: the tightest group on the path counts") {
  const GroupTree tree("v2");
  tree.write("cpu.max", "max 100000\n");
  tree.write("a/cpu.max", "150000 100000\n");
  tree.write("a/b/cpu.max", "400000 100000\n");
  CHECK(limit(tree, "0::/a/b\n") == 1.5);
  CHECK(limit(tree, "0::/\n") == std::nullopt);
}

TEST_CASE("control groups, version 2: a path of the host falls back to the mount point") {
  const GroupTree tree("host");
  tree.write("cpu.max", "200000 100000\n");
  CHECK(limit(tree, "0::/kubepods/not/visible\n") == 2.0);
}

TEST_CASE("control groups, version 1: quota and period of the cpu controller") {
  const GroupTree tree("v1");
  tree.write("cpu/a/cpu.cfs_quota_us", "50000\n");
  tree.write("cpu/a/cpu.cfs_period_us", "100000\n");
  tree.write("cpu/free/cpu.cfs_quota_us", "-1\n");
  tree.write("cpu/free/cpu.cfs_period_us", "100000\n");
  CHECK(limit(tree, "5:cpuset:/a\n4:cpu,cpuacct:/a\n") == 0.5);
  CHECK(limit(tree, "4:cpuacct,cpu:/free\n") == std::nullopt);
  CHECK(limit(tree, "4:cpuset:/a\n") == std::nullopt);
}

TEST_CASE("control groups: nothing readable sets no limit") {
  const GroupTree tree("none");
  CHECK(limit(tree, "") == std::nullopt);
  CHECK(limit(tree, "nonsense\n0::/a\n") == std::nullopt);
}
