#pragma once

// The file that keeps a study's runs, from which --resume continues.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/output_file.h"
#include "program/study/single_run.h"
#include "program/study/study.h"

namespace spoke::study {

/// The results of runs in the order in which they ended, each with a checksum. A record that was
/// not written to its end does not count: whenever the program is killed, the file holds whole
/// runs. Memory holds only each run's place, 8 bytes.
class Journal {
 public:
  enum class Start {
    anew,     ///< makes or empties the file
    resumed,  ///< goes on behind the runs that the file has
  };
  /// Opens the file. Throws InputError if it cannot be written, and if a journal to be resumed is
  /// not there, is no journal, or belongs to another study.
  Journal(const std::string& file, const Study& study, Start start);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::int64_t run) const { return places_[static_cast<std::size_t>(run)] != 0; }
  /// Returns the number of runs that it has.
  std::int64_t count() const { return count_; }
  bool is_complete() const { return count_ == static_cast<std::int64_t>(places_.size()); }

  /// Adds a run that it lacks. Throws InputError if it cannot be written.
  void append(const RunResult& result);
  /// Returns a run that it has. Throws InputError if it cannot be read or is corrupt.
  RunResult read(std::int64_t run) const;
  /// Returns when the disk has all runs.
  void sync() { output_->sync(); }

 private:
  void open_reader();
  void find_records(const Study& study);

  std::string file_;
  std::unique_ptr<OutputFile> output_;
  int reader_ = -1;                    ///< descriptor
  std::vector<std::uint64_t> places_;  ///< place of each run's record in the file; 0: none
  std::int64_t count_ = 0;
};

/// The state of a journal in a file: the number of runs that it has, and of all runs.
/// find_journal() returns none if there is no journal.
struct JournalState {
  std::int64_t runs = 0, planned = 0;
  std::string instructions;  ///< instructions that it was begun with
};
std::optional<JournalState> find_journal(const std::string& file);

/// Returns a number, not 0, that differs for studies with other results: it depends on their texts,
/// the version of Spoke, and the instructions that this process computes with.
std::uint64_t fingerprint(const Study& study);

/// Converts a result to bytes, and back. Throws InputError if the bytes are no result; `name` is
/// their name in messages.
std::string pack(const RunResult& result);
RunResult unpack(std::string_view bytes, const std::string& name);

}  // namespace spoke::study
