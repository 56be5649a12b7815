// Finds out whether a folder can be made without making it.

#include "engine/cli/results_folder.h"

#include <unistd.h>

#include <string>
#include <system_error>

#include "models/error.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw InputError(folder.string() + ": cannot be the folder of results: " + reason);
}

/// Also of a link to nothing, in whose place nothing can be made.
bool is_there(const fs::path& path, std::error_code& error) {
  std::error_code none;
  return fs::exists(path, error) || fs::is_symlink(fs::symlink_status(path, none));
}

}  // namespace

void require_folder(const fs::path& folder) {
  std::error_code error;
  fs::path existing = fs::absolute(folder, error);
  while (!error && !is_there(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  if (error) refuse(folder, error.message());
  if (!fs::is_directory(existing)) refuse(folder, existing.string() + " is no folder");
  if (access(existing.c_str(), W_OK | X_OK) != 0)
    refuse(folder, existing.string() + " is not writable");
}

void require_no_folder(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error))
    throw InputError(file.string() + ": cannot be written: Is a directory");
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) refuse(folder, error.message());
}

}  // namespace spoke::cli
