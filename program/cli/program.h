#pragma once

// A program that runs commands: from the words of a command line to an exit status. `spoke` is one.
// Some of its commands are programs of their own, which it starts: `spoke study` starts
// `spoke-study`, which stands beside it, knows this command alone, and may be started by itself. A
// build may leave them out.

#include <functional>
#include <string>
#include <vector>

#include "program/cli/arguments.h"

namespace CLI {
class App;
}

namespace spoke::cli {

/// A command of a program.
struct Command {
  const char* name;
  const char* summary;  ///< line in the program's --help
  /// Adds the command's options, which refer to `arguments`. Null: the command is a program of its
  /// own.
  std::function<void(CLI::App& command, Arguments& arguments)> add_options = nullptr;
  /// Returns the exit status.
  std::function<int(const Arguments& arguments)> execute = nullptr;
  /// Whether the command's result is its output on the terminal, rather than files.
  bool prints_result = false;
  /// Returns the instructions (`--instructions`) with which earlier results were computed, if the
  /// command goes on with such, else an empty text. May be null.
  std::function<std::string(const Arguments& arguments)> instructions_before = nullptr;
};

/// Prepares streams, signals and environment of a process. Returns false if standard output is
/// closed.
bool prepare_process();

/// Runs the program `spoke`. Returns the exit status; every failure is reported on standard error.
int run_program(const std::vector<Command>& commands, int argc, char** argv);

/// Runs the program `spoke-NAME` of a command of that name, as run_program() would `spoke NAME`.
int run_program(const Command& command, int argc, char** argv);

}  // namespace spoke::cli
