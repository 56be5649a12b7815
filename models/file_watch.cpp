// Keeps who is told of files.

#include "models/file_watch.h"

#include <atomic>

namespace spoke {
namespace {

std::atomic<FileWatch*> file_watch{nullptr};

}  // namespace

void set_file_watch(FileWatch* watch) { file_watch = watch; }

void announce_reading(const std::filesystem::path& file) {
  if (FileWatch* const watch = file_watch) watch->will_read(file);
}

void announce_replacing(const std::filesystem::path& file) {
  if (FileWatch* const watch = file_watch) watch->will_replace(file);
}

}  // namespace spoke
