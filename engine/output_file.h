#pragma once

// Files that results are written to, with an error for everything that can go wrong.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spoke/export.h"

namespace spoke {

/// A file that is written from front to back, without a buffer, by system calls. All functions
/// throw InputError, "FILE: cannot be written: REASON" with the reason of the system, if their work
/// cannot be done.
class SPOKE_EXPORT OutputFile {
 public:
  /// Treatment of an existing file of that name.
  enum class Start {
    empty,    ///< the file is made, or emptied
    existing  ///< the file must exist; writing goes on at its end
  };
  /// Opens the file.
  explicit OutputFile(std::string file, Start start = Start::empty);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends bytes. If not all can be written, size() tells how much was. A file that was removed
  /// meanwhile is an error here and below.
  void append(std::string_view bytes);
  /// Removes all bytes behind the first `size` ones.
  void cut(std::uint64_t size);
  /// Returns when all that was written is on the disk.
  void sync();
  /// Closes the file, which must not be used afterwards.
  void close();

  std::uint64_t size() const { return size_; }  ///< [bytes]
  /// Returns the path as it was given.
  const std::string& path() const { return file_; }

 private:
  void require_not_removed() const;

  std::string file_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// A file that is removed if the process ends by a signal while this object lives: one that has not
/// taken its final place yet, or a folder, which is removed if it is empty. The program must call
/// remove_unfinished_files() on the signal.
class SPOKE_EXPORT UnfinishedFile {
 public:
  /// Notes the name; does not make the file.
  explicit UnfinishedFile(std::string file);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  std::string file_;
  int slot_ = -1;  ///< where it is noted; negative: nowhere, since there are too many
};

/// Removes all UnfinishedFiles of the process. May be called in a handler of a signal that then
/// ends the process.
SPOKE_EXPORT void remove_unfinished_files() noexcept;

/// Events that a new file has to survive.
enum class Outlives {
  process,  ///< failure or end of the program
  machine   ///< also a crash or power cut: waits for the disk, some milliseconds
};
/// A file that takes the place of another one, or of none, as a whole. Readers see the old file or
/// the new one; so do programs that start after an event that it outlives. Devices and pipes keep
/// their place, and are written to. Throws InputError if it cannot be written.
class SPOKE_EXPORT ReplacedFile {
 public:
  /// Opens a file beside `file`, with ".tmp" added to the name.
  explicit ReplacedFile(std::string file);
  /// Removes the temporary file unless it has taken its place.
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  void append(std::string_view bytes);
  /// Puts the file in its place. Must be called once at most.
  void commit(Outlives outlives = Outlives::machine);

 private:
  template <class Work>
  void name_the_file(const Work& work) const;

  std::string file_, temporary_;
  std::optional<UnfinishedFile> unfinished_;  ///< the temporary file, if there is one
  std::unique_ptr<OutputFile> output_;
};

/// Replaces a file as a whole by these bytes, see ReplacedFile.
SPOKE_EXPORT void replace_file(const std::string& file, std::string_view bytes,
                               Outlives outlives = Outlives::machine);

/// The name of a file, and what is to stand in it.
struct FileText {
  std::string file, text;
};
/// Replaces files that belong together: all of them lie beside their places before the first takes
/// its own, so that none is replaced if one of them cannot be written.
SPOKE_EXPORT void replace_files(const std::vector<FileText>& files,
                                Outlives outlives = Outlives::machine);

}  // namespace spoke
