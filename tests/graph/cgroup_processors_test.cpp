#include "graph/cgroup_processors.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

// A folder of files as control groups show them, removed at the end.
class GroupTree {
 public:
  explicit GroupTree(const std::string& name)
      : root_(fs::temp_directory_path() /
              ("spoke-cgroup-" + name + "-" + std::to_string(::getpid()))) {
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  GroupTree(const GroupTree&) = delete;
  GroupTree& operator=(const GroupTree&) = delete;
  ~GroupTree() { fs::remove_all(root_); }

  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  std::optional<double> limit(const std::string& membership) const {
    std::istringstream lines(membership);
    return spoke::graph::cgroup_processors(lines, root_);
  }

 private:
  fs::path root_;
};

}  // namespace

TEST_CASE("control groups, version 2: the tightest group on the path counts") {
  const GroupTree tree("v2");
  tree.write("cpu.max", "max 100000\n");
  tree.write("a/cpu.max", "150000 100000\n");
  tree.write("a/b/cpu.max", "400000 100000\n");
  CHECK(tree.limit("0::/a/b\n") == 1.5);
  CHECK(tree.limit("0::/\n") == std::nullopt);
}

TEST_CASE("control groups, version 2: a path of the host falls back to the mount point") {
  const GroupTree tree("host");
  tree.write("cpu.max", "200000 100000\n");
  CHECK(tree.limit("0::/kubepods/not/visible\n") == 2.0);
}

TEST_CASE("control groups, version 1: quota and period of the cpu controller") {
  const GroupTree tree("v1");
  tree.write("cpu/a/cpu.cfs_quota_us", "50000\n");
  tree.write("cpu/a/cpu.cfs_period_us", "100000\n");
  tree.write("cpu/free/cpu.cfs_quota_us", "-1\n");
  tree.write("cpu/free/cpu.cfs_period_us", "100000\n");
  CHECK(tree.limit("5:cpuset:/a\n4:cpu,cpuacct:/a\n") == 0.5);
  CHECK(tree.limit("4:cpuacct,cpu:/free\n") == std::nullopt);
  CHECK(tree.limit("4:cpuset:/a\n") == std::nullopt);
}

TEST_CASE("control groups: nothing readable sets no limit") {
  const GroupTree tree("none");
  CHECK(tree.limit("") == std::nullopt);
  CHECK(tree.limit("nonsense\n0::/a\n") == std::nullopt);
}
