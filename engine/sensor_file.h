#pragma once

// Writes and reads the file sensors.csv.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/output_file.h"
#include "spoke/export.h"

namespace spoke {

/// A position in sensors.csv, and a checksum that identifies the bytes before it.
struct SensorFileMark {
  std::uint64_t bytes = 0;     ///< written so far
  std::uint32_t checksum = 0;  ///< CRC-32 of these bytes
};

/// Writes sensors.csv: a header of names, then rows of numbers in the fewest digits that read back
/// equal. Throws InputError on every failure; the file then ends with a complete row.
class SPOKE_EXPORT SensorFile {
 public:
  /// Creates the file.
  SensorFile(std::string file, const std::vector<std::string>& names);
  /// Goes on behind a mark, with the content of `source` up to there, which may be the file itself.
  /// Throws InputError, and changes nothing, if `source` does not begin with the marked bytes.
  SensorFile(std::string file, const SensorFileMark& mark, const std::string& source);

  /// Writes one row: the time [s], then a value for each name.
  void write_row(double t, std::span<const double> values);
  /// Synchronises all rows so far with the disk, and returns a mark behind them.
  SensorFileMark sync();
  /// Writes the rows so far and closes the file. Rows are lost without a word unless this is
  /// called.
  void close();

 private:
  void end_line();
  void flush();

  OutputFile output_;
  std::string lines_;  ///< rows that are not written yet
  std::uint32_t checksum_ = 0;
};

/// Calls `visit` for every row of a sensors.csv that SensorFile has written. Throws InputError if
/// it cannot be read.
SPOKE_EXPORT void read_rows(
    const std::string& file,
    const std::function<void(double t, std::span<const double> values)>& visit);

}  // namespace spoke
