#pragma once

// What a program may want to know of files: which ones are read, and which are about to be written.

#include <filesystem>

namespace spoke {

/// Is told of files. Threads may call at once.
class FileWatch {
 public:
  virtual ~FileWatch() = default;
  /// Something of what is simulated is read from this file.
  virtual void will_read(const std::filesystem::path& file) = 0;
  /// This file is about to be made, emptied or replaced. Throws InputError to forbid it.
  virtual void will_replace(const std::filesystem::path& file) = 0;
};

/// From now on has `watch` told of all files of this process, which must live as long as that;
/// null, as it is at the start: nobody is told.
void set_file_watch(FileWatch* watch);

/// Tells the watch, if there is one. Readers and writers call these before they open a file.
void announce_reading(const std::filesystem::path& file);
void announce_replacing(const std::filesystem::path& file);

}  // namespace spoke
