#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace spoke::test {

/// A folder of files as control groups show them, removed at the end.
class GroupTree {
 public:
  explicit GroupTree(const std::string& name)
      : root_(std::filesystem::temp_directory_path() /
              ("spoke-cgroup-" + name + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
  }
  GroupTree(const GroupTree&) = delete;
  GroupTree& operator=(const GroupTree&) = delete;
  ~GroupTree() { std::filesystem::remove_all(root_); }

  const std::filesystem::path& root() const { return root_; }
  void write(const std::filesystem::path& file, const std::string& text) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }

 private:
  std::filesystem::path root_;
};

}  // namespace spoke::test
