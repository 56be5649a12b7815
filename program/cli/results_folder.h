#pragma once

// Folders and files that a command writes.

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/output_file.h"

namespace spoke::cli {

/// Throws InputError unless the folder can be made, without making it, and if in it one of the
/// results may not be written, see require_places().
void require_folder(const std::filesystem::path& folder,
                    const std::vector<std::string>& files = {});

/// A folder to which only this process writes, among all that take it by this class. The lock is
/// the system's, not a file: it ends with the process, however that ends. Where the system has no
/// locks (some network drives), or the folder may not be read, it is not locked.
class ResultsFolder {
 public:
  /// Makes the folder and those above it, unless they exist, and locks it. Throws InputError if it
  /// cannot be made or another process has locked it.
  explicit ResultsFolder(std::filesystem::path folder);
  /// Removes the folders that it made, if nothing was written to them. So does a signal that ends
  /// the process.
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

 private:
  void make();
  bool lock();
  void remove_made() const;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< each within the one before
  std::deque<UnfinishedFile> unfinished_;    ///< the same, for signals
  int descriptor_ = -1;                      ///< open folder that carries the lock
};

}  // namespace spoke::cli
