#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace spoke::bench {

/// A folder for the results, removed at the end.
class ResultsFolder {
 public:
  ResultsFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "spoke-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
    path_ = name;
  }
  ~ResultsFolder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace spoke::bench
