#pragma once

// Standard input, output and error of the program, which may be closed, full or without a reader.

#include <string_view>

namespace spoke::cli {

/// Opens /dev/null in place of those of the three that are closed, so that no file of results takes
/// their numbers, and makes errors of the signals that a stream without a reader and a file beyond
/// the process's limit send. To be called before anything opens a file. False if standard output
/// was closed.
bool open_standard_streams();

/// Writes to standard output. That it cannot be written is told by flush_output().
void print(std::string_view text);

/// Writes a line to standard error, behind what standard output holds. Nothing can be told if it
/// cannot be written.
void print_error(std::string_view line);

/// Flushes standard output. The system's reason if not all of what was printed could be written,
/// else null.
const char* flush_output();

}  // namespace spoke::cli
