// Writes by system calls, so that every failure is noticed, and synchronises files with the disk.

#include "engine/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <string>
#include <utility>

#include "models/error.h"
#include "models/file_watch.h"

namespace spoke {
namespace {

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
  throw InputError(file + ": cannot be written: " + reason);
}

[[noreturn]] void fail(const std::string& file) { fail(file, std::strerror(errno)); }

/// Repeats a system call that a signal interrupted.
template <class Call>
auto without_interruption(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

/// Whether a file is synchronised with the disk: devices and pipes cannot be, and need not.
bool is_synchronised(int descriptor) {
  return without_interruption([&] { return fsync(descriptor); }) == 0 || errno == EINVAL ||
         errno == EROFS;
}

/// Whether a file is a device or a pipe, or a link to one.
bool is_device(const std::string& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// Synchronises a folder, so that a new name in it survives a crash.
void sync_folder(const std::string& file) {
  std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (folder.empty()) folder = ".";
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0 && errno == EACCES) return;  // the folder may be written to, but not read
  if (descriptor < 0) fail(file);
  const bool is_done = is_synchronised(descriptor);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  if (!is_done) fail(file);
}

/// The names of files that are not finished. Handlers of signals read them, so nothing here waits.
std::array<std::atomic<const char*>, 32> unfinished_files{};
static_assert(std::atomic<const char*>::is_always_lock_free);

}  // namespace

OutputFile::OutputFile(std::string file, Start start) : file_(std::move(file)) {
  if (start == Start::empty) announce_replacing(file_);
  const int flags = start == Start::empty ? O_CREAT | O_TRUNC : O_APPEND;
  descriptor_ =
      without_interruption([&] { return open(file_.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666); });
  if (descriptor_ < 0) fail(file_);
  if (start == Start::empty) return;
  const off_t end = lseek(descriptor_, 0, SEEK_END);
  if (end > 0) size_ = static_cast<std::uint64_t>(end);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::append(std::string_view bytes) {
  require_not_removed();
  while (!bytes.empty()) {
    const ssize_t count =
        without_interruption([&] { return write(descriptor_, bytes.data(), bytes.size()); });
    if (count < 0) fail(file_);
    size_ += static_cast<std::uint64_t>(count);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::cut(std::uint64_t size) {
  const auto end = static_cast<off_t>(size);
  if (ftruncate(descriptor_, end) != 0 || lseek(descriptor_, end, SEEK_SET) < 0) fail(file_);
  size_ = size;
}

void OutputFile::sync() {
  if (!is_synchronised(descriptor_)) fail(file_);
  require_not_removed();
}

void OutputFile::close() {
  require_not_removed();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(file_);
}

void OutputFile::require_not_removed() const {
  struct stat status {};
  if (fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 0)
    fail(file_, "it was removed meanwhile");
}

UnfinishedFile::UnfinishedFile(std::string file) : file_(std::move(file)) {
  for (std::size_t slot = 0; slot < unfinished_files.size() && slot_ < 0; ++slot) {
    const char* none = nullptr;
    if (unfinished_files[slot].compare_exchange_strong(none, file_.c_str()))
      slot_ = static_cast<int>(slot);
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (slot_ >= 0) unfinished_files[static_cast<std::size_t>(slot_)] = nullptr;
}

void remove_unfinished_files() noexcept {
  for (const std::atomic<const char*>& file : unfinished_files)
    if (const char* const name = file.load()) unlink(name);
  // A folder may hold others, which are noted in any order.
  bool is_removed = true;
  while (is_removed) {
    is_removed = false;
    for (const std::atomic<const char*>& folder : unfinished_files)
      if (const char* const name = folder.load()) is_removed = rmdir(name) == 0 || is_removed;
  }
}

/// Runs `work`; messages of its errors name the file that was asked for.
template <class Work>
void ReplacedFile::name_the_file(const Work& work) const {
  try {
    work();
  } catch (const InputError& error) {
    const std::string text = error.what();
    throw InputError(text.starts_with(temporary_) ? file_ + text.substr(temporary_.size()) : text);
  }
}

ReplacedFile::ReplacedFile(std::string file)
    : file_(std::move(file)), temporary_(is_device(file_) ? file_ : file_ + ".tmp") {
  announce_replacing(file_);
  if (temporary_ != file_) unfinished_.emplace(temporary_);
  name_the_file([&] { output_ = std::make_unique<OutputFile>(temporary_); });
}

ReplacedFile::~ReplacedFile() {
  if (output_ && temporary_ != file_) unlink(temporary_.c_str());
}

void ReplacedFile::append(std::string_view bytes) {
  name_the_file([&] { output_->append(bytes); });
}

void ReplacedFile::commit(Outlives outlives) {
  name_the_file([&] {
    if (outlives == Outlives::machine) output_->sync();
    output_->close();
    if (temporary_ != file_ && std::rename(temporary_.c_str(), file_.c_str()) != 0) fail(file_);
  });
  output_.reset();
  unfinished_.reset();
  if (outlives == Outlives::machine) sync_folder(file_);
}

void replace_file(const std::string& file, std::string_view bytes, Outlives outlives) {
  ReplacedFile replaced(file);
  replaced.append(bytes);
  replaced.commit(outlives);
}

void replace_files(const std::vector<FileText>& files, Outlives outlives) {
  std::deque<ReplacedFile> replaced;
  for (const FileText& file : files) replaced.emplace_back(file.file).append(file.text);
  for (ReplacedFile& file : replaced) file.commit(outlives);
}

}  // namespace spoke
