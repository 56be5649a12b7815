#include "engine/support/memory.h"

#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "tests/group_tree.h"

using spoke::test::GroupTree;

namespace {

std::optional<double> limit(const GroupTree& tree, const std::string& membership) {
  std::istringstream lines(membership);
  return spoke::cgroup_memory(lines, tree.root());
}

}  // namespace

TEST_CASE("memory of control groups, version 2: the tightest group on the path counts") {
  const GroupTree tree("memory-v2");
  tree.write("a/memory.max", "2147483648\n");
  tree.write("a/b/memory.max", "max\n");
  tree.write("a/b/c/memory.max", "4294967296\n");
  CHECK(limit(tree, "0::/a/b/c\n") == 2147483648.0);
  CHECK(limit(tree, "0::/\n") == std::nullopt);
}

TEST_CASE("memory of control groups, version 1: the limit of the memory controller") {
  const GroupTree tree("memory-v1");
  tree.write("memory/memory.limit_in_bytes", "9223372036854771712\n");
  tree.write("memory/a/memory.limit_in_bytes", "536870912\n");
  CHECK(limit(tree, "4:memory:/a\n1:cpu:/\n0::/\n") == 536870912.0);
  CHECK(limit(tree, "4:memory:/\n") == 9223372036854771712.0);
  CHECK(limit(tree, "4:cpu:/a\n") == std::nullopt);
}

TEST_CASE("the available memory is some, and at most the machine's") {
  CHECK(spoke::available_memory() > 0.0);
  if (spoke::physical_memory() > 0) {
    CHECK(spoke::available_memory() <= static_cast<double>(spoke::physical_memory()));
  }
}
