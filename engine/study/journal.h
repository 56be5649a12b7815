#pragma once

// The file that a study's runs are kept in while it lasts, and after: what --resume goes on from.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/output_file.h"
#include "engine/study/single_run.h"
#include "engine/study/study.h"

namespace spoke::study {

/// The results of runs in the order in which they ended, each with a checksum. A record that was
/// not written to its end is none: whenever the program is killed, the file holds whole runs. Of
/// each run 8 bytes are kept in memory, where it stands.
class Journal {
 public:
  enum class Start {
    anew,     ///< the file is made, or emptied
    resumed,  ///< goes on behind the runs that the file has
  };
  /// Throws InputError if the file cannot be written; of a resumed one also if it is not there, is
  /// no journal, or is of another study.
  Journal(const std::string& file, const Study& study, Start start);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::int64_t run) const { return places_[static_cast<std::size_t>(run)] != 0; }
  /// Of runs that it has.
  std::int64_t count() const { return count_; }
  bool is_complete() const { return count_ == static_cast<std::int64_t>(places_.size()); }

  /// Adds a run that it has not. Throws InputError if it cannot be written.
  void append(const RunResult& result);
  /// A run that it has. Throws InputError if it cannot be read, or not as it was written.
  RunResult read(std::int64_t run) const;
  /// Returns when the disk has all runs.
  void sync() { output_->sync(); }

 private:
  void open_reader();
  void find_records(const Study& study);

  std::string file_;
  std::unique_ptr<OutputFile> output_;
  int reader_ = -1;                    ///< descriptor
  std::vector<std::uint64_t> places_;  ///< by run: its record in the file; 0: none
  std::int64_t count_ = 0;
};

/// What a journal is that somebody left in a file: the runs that it has, of how many; nothing if
/// there is none.
struct JournalState {
  std::int64_t runs = 0, planned = 0;
  std::string instructions;  ///< that it was begun with
};
std::optional<JournalState> find_journal(const std::string& file);

/// What tells studies apart that would have other results: their texts, the version of Spoke, and
/// the instructions that this process computes with. Not 0.
std::uint64_t fingerprint(const Study& study);

/// A result as bytes, and back. Throws InputError if the bytes are none; `name` stands for them.
std::string pack(const RunResult& result);
RunResult unpack(std::string_view bytes, const std::string& name);

}  // namespace spoke::study
