#pragma once

// The folders and files that a command is to write.

#include <filesystem>
#include <string>
#include <vector>

namespace spoke::cli {

/// Throws InputError unless the folder can be made, without making it, and if in it a folder stands
/// where one of the files is to be written.
void require_folder(const std::filesystem::path& folder,
                    const std::vector<std::string>& files = {});

/// Throws InputError if a folder stands where a file is to be written.
void require_no_folder(const std::filesystem::path& file);

/// A folder that this process alone writes to, of all that take it by this class. It is locked in
/// the system, not by a file: the lock ends with the process, however that ends. Where the system
/// knows no locks (some network drives), or the folder may not be read, there is none.
class ResultsFolder {
 public:
  /// Makes the folder and those above it, unless they exist, and locks it. Throws InputError if it
  /// cannot be made or another process has it.
  explicit ResultsFolder(std::filesystem::path folder);
  /// Removes what it made, if nothing was written to it.
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

 private:
  void make();
  bool lock();
  void remove_made() const;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< each within the one before
  int descriptor_ = -1;                      ///< of the lock
};

}  // namespace spoke::cli
