#pragma once

// The file sensors.csv, written and read again.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/output_file.h"
#include "spoke/export.h"

namespace spoke {

/// How far a sensors.csv has been written, and a checksum by which that much of it is known again.
struct SensorFileMark {
  std::uint64_t bytes = 0;     ///< written so far
  std::uint32_t checksum = 0;  ///< CRC-32 of these bytes
};

/// sensors.csv: a header of names, then rows of numbers in the fewest digits that read back equal.
/// Whatever cannot be done throws InputError; the file then ends with a complete row.
class SPOKE_EXPORT SensorFile {
 public:
  /// Creates the file.
  SensorFile(std::string file, const std::vector<std::string>& names);
  /// Goes on behind a mark: with what `source` holds up to there, which may be the file itself.
  /// Changes nothing if that is not what was marked.
  SensorFile(std::string file, const SensorFileMark& mark, const std::string& source);

  /// One row: the time [s], then a value for each name.
  void write_row(double t, std::span<const double> values);
  /// Synchronises all rows so far with the disk, and returns how far the file goes.
  SensorFileMark sync();
  /// Writes the rows so far. Rows are lost without a word unless this is called.
  void close();

 private:
  void end_line();
  void flush();

  OutputFile output_;
  std::string lines_;  ///< not written yet
  std::uint32_t checksum_ = 0;
};

/// Calls `visit` for every row of a sensors.csv that a SensorFile has written. Throws InputError if
/// it cannot be read.
SPOKE_EXPORT void read_rows(
    const std::string& file,
    const std::function<void(double t, std::span<const double> values)>& visit);

}  // namespace spoke
