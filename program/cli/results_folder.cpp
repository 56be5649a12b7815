// Finds out whether a folder can be made without making it; makes it and locks it.

#include "program/cli/results_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "models/error.h"
#include "program/cli/file_guard.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw InputError(folder.string() + ": cannot be the folder of results: " + reason);
}

/// Whether something has that name. A link to nothing counts, for nothing can be made in its place.
bool is_there(const fs::path& path, std::error_code& error) {
  std::error_code none;
  return fs::exists(path, error) || fs::is_symlink(fs::symlink_status(path, none));
}

/// Whether the open folder still has that name; it may have been removed or replaced.
bool is_named(int descriptor, const fs::path& folder) {
  struct stat opened {
  }, named{};
  return fstat(descriptor, &opened) == 0 && stat(folder.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

void require_folder(const fs::path& folder, const std::vector<std::string>& files) {
  std::error_code error;
  fs::path existing = fs::absolute(folder, error);
  while (!error && !is_there(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  if (error) refuse(folder, error.message());
  if (!fs::is_directory(existing, error)) refuse(folder, existing.string() + " is no folder");
  if (access(existing.c_str(), W_OK | X_OK) != 0)
    refuse(folder, existing.string() + " is not writable");
  require_places(folder, files);
}

ResultsFolder::ResultsFolder(fs::path folder) : path_(std::move(folder)) {
  do make();
  while (!lock());
}

ResultsFolder::~ResultsFolder() {
  remove_made();
  if (descriptor_ >= 0) close(descriptor_);  // last, so that no other locks a removed folder
}

void ResultsFolder::make() {
  fs::path folder;
  for (const fs::path& name : path_) {
    folder /= name;
    std::error_code error, none;
    const bool is_missing = !fs::exists(folder, none);
    if (is_missing) unfinished_.emplace_back(folder.string());  // first: a signal may come any time
    if (fs::create_directory(folder, error))
      made_.push_back(folder);
    else if (is_missing)
      unfinished_.pop_back();
    if (!error || fs::is_directory(folder, none)) continue;
    remove_made();
    refuse(path_, error.message());
  }
}

/// Locks the folder. Returns false if it vanished meanwhile.
bool ResultsFolder::lock() {
  descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) return errno != ENOENT;
  const bool is_taken = flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (!is_taken && is_named(descriptor_, path_)) return true;
  close(std::exchange(descriptor_, -1));
  if (is_taken) refuse(path_, "another run of spoke is writing to it");
  return false;
}

void ResultsFolder::remove_made() const {
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
    if (rmdir(folder->c_str()) != 0) return;  // it holds something
}

}  // namespace spoke::cli
