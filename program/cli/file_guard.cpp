// Knows files by device and number, which all names and links of a file share.

#include "program/cli/file_guard.h"

#include <sys/stat.h>

#include <atomic>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "models/error.h"
#include "models/file_watch.h"
#include "program/cli/report.h"
#include "program/cli/standard_streams.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

using FileNumber = std::pair<dev_t, ino_t>;

/// Returns what all names and links of a regular file share.
std::optional<FileNumber> number_of(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  return FileNumber(status.st_dev, status.st_ino);
}

[[noreturn]] void refuse_place(const fs::path& file, const std::string& reason) {
  throw InputError(file.string() + ": cannot be written: " + reason);
}

/// Tells of a named pipe, at which the command waits for as long as nobody writes to it.
void tell_of_pipe(const fs::path& file) {
  std::error_code none;
  if (fs::is_fifo(fs::symlink_status(file, none)))
    print_error(one_line(file.string()) + ": is a pipe, waiting for what is written to it");
}

/// Notes what is read, and refuses to replace it.
class FileGuard final : public FileWatch {
 public:
  void will_read(const fs::path& file) override {
    tell_of_pipe(file);
    const std::optional<FileNumber> number = number_of(file);
    const std::lock_guard lock(mutex_);
    if (number) read_.insert(*number);
  }
  void will_replace(const fs::path& file) override {
    const std::optional<FileNumber> number = number_of(file);
    const std::lock_guard lock(mutex_);
    if (number && read_.count(*number) > 0)
      refuse_place(file, "the command reads this file, expected another name");
  }

  std::atomic<bool> may_replace_other_kinds{false};

 private:
  std::mutex mutex_;
  std::set<FileNumber> read_;
};

FileGuard file_guard;

/// Whether a regular file that is not empty stands there, and is not of the kind.
bool is_of_other_kind(const fs::path& file, const FileKind& kind) {
  std::error_code none;
  if (!fs::is_regular_file(file, none) || fs::file_size(file, none) == 0) return false;
  std::ifstream stream(file, std::ios::binary);
  std::string head(kHead, '\0');
  stream.read(head.data(), kHead);
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return !kind.has(head);
}

void require_name(const fs::path& file, const FileKind& kind) {
  std::error_code none;
  if (fs::is_directory(file, none)) refuse_place(file, "Is a directory");
  file_guard.will_replace(file);
  if (!file_guard.may_replace_other_kinds && is_of_other_kind(file, kind))
    refuse_place(file, std::string("there is a file that is not ") + kind.name +
                           ", expected another name, or --force to replace it");
}

}  // namespace

void guard_files() { set_file_watch(&file_guard); }

void let_replace_other_kinds() { file_guard.may_replace_other_kinds = true; }

void require_place(const fs::path& file, const FileKind& kind) {
  require_name(file, kind);
  require_name(file.string() + ".tmp", kind);
}

void require_places(const fs::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) require_place(folder / name, kind_of_result(name));
}

}  // namespace spoke::cli
