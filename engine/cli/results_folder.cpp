#include "engine/cli/results_folder.h"

#include <unistd.h>

#include <system_error>

#include "models/error.h"

namespace spoke::cli {

namespace fs = std::filesystem;

void demand_folder(const fs::path& folder) {
  std::error_code error;
  fs::path existing = fs::absolute(folder, error);
  while (!error && !fs::exists(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  std::string reason;
  if (error) {
    reason = error.message();
  } else if (!fs::is_directory(existing)) {
    reason = existing.string() + " is no folder";
  } else if (access(existing.c_str(), W_OK | X_OK) != 0) {
    reason = existing.string() + " is not writable";
  }
  if (!reason.empty())
    throw InputError(folder.string() + ": cannot be the folder of results: " + reason);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError(folder.string() + ": cannot be the folder of results: " + error.message());
}

}  // namespace spoke::cli
