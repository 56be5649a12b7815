#pragma once

// Files that results are written to, with an error for everything that can go wrong.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "spoke/export.h"

namespace spoke {

/// A file that is written from front to back, without a buffer, by the system's calls. What cannot
/// be done throws InputError, "FILE: cannot be written: REASON", with the system's reason.
class SPOKE_EXPORT OutputFile {
 public:
  /// What becomes of a file of that name.
  enum class Start {
    empty,    ///< made, or emptied
    existing  ///< must be there; goes on at its end
  };
  /// Opens the file.
  explicit OutputFile(std::string file, Start start = Start::empty);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// If not all of it can be written, size() tells how much was. A file that was removed meanwhile
  /// is an error, here and below.
  void append(std::string_view bytes);
  /// Cuts off what stands behind the first `size` bytes.
  void cut(std::uint64_t size);
  /// Returns when the disk has what was written.
  void sync();
  /// Not to be used afterwards.
  void close();

  std::uint64_t size() const { return size_; }  ///< [bytes]
  /// As it was given.
  const std::string& path() const { return file_; }

 private:
  void require_not_removed() const;

  std::string file_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// A file that is removed if the process ends by a signal while this lives, where the program has
/// arranged for remove_unfinished_files(): what has not taken its place yet.
class SPOKE_EXPORT UnfinishedFile {
 public:
  /// Not the file itself is made.
  explicit UnfinishedFile(std::string file);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  std::string file_;
  int slot_ = -1;  ///< where it is noted; negative: nowhere, there are too many
};

/// Removes all UnfinishedFiles of the process. May be called in a handler of a signal that then
/// ends the process.
SPOKE_EXPORT void remove_unfinished_files() noexcept;

/// What a new file has to outlive.
enum class Outlives {
  process,  ///< a program that fails or is killed
  machine   ///< a crash or power cut, too: the disk is waited for, some milliseconds
};
/// A file that takes the place of another one, or of none, as a whole: readers, and programs that
/// start after what it outlives, see the old file or the new one. Devices and pipes keep their
/// place, and are written to. Throws InputError if it cannot be written.
class SPOKE_EXPORT ReplacedFile {
 public:
  /// Opens a file beside `file`, of that name and ".tmp".
  explicit ReplacedFile(std::string file);
  /// Removes what has not taken the place.
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  void append(std::string_view bytes);
  /// Takes the place, once.
  void commit(Outlives outlives = Outlives::machine);

 private:
  template <class Work>
  void name_the_file(const Work& work) const;

  std::string file_, temporary_;
  std::optional<UnfinishedFile> unfinished_;  ///< the temporary one, if it is one
  std::unique_ptr<OutputFile> output_;
};

/// Replaces a file as a whole by these bytes, see ReplacedFile.
SPOKE_EXPORT void replace_file(const std::string& file, std::string_view bytes,
                               Outlives outlives = Outlives::machine);

}  // namespace spoke
