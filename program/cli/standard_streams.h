#pragma once

// Standard input, output and error of the program, which may be closed, full or without a reader.

#include <string_view>

namespace spoke::cli {

/// Opens /dev/null in place of those of the three that are closed, so that no file of results takes
/// their numbers, and makes errors of the signals that a stream without a reader and a file beyond
/// the process's limit send. Must be called before anything opens a file. Returns false if standard
/// output was closed.
bool open_standard_streams();

/// Writes to standard output. Failures are reported by flush_output().
void print(std::string_view text);

/// Writes a line to standard error, after flushing standard output. Failures are ignored.
void print_error(std::string_view line);

/// Flushes standard output. Returns the system's reason if not all output could be written, else
/// null.
const char* flush_output();

}  // namespace spoke::cli
