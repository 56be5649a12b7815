#pragma once

// A program that runs commands: from the words of a command line to an exit status. `spoke` is one.
// Most of its commands are those of other programs, which stand beside it and which it starts:
// `spoke study` starts `spoke-study`, which knows this command alone; `spoke static` starts
// `spoke-whole`, which knows all that need the whole engine. Each may be started by itself. A build
// may leave them out; the script ./spoke builds them when they are first asked for.

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
  /// The command is one of the program `spoke-PROGRAM`; null: it is all of the program
  /// `spoke-NAME`.
  const char* program = nullptr;
  const char* summary = "";  ///< line in the program's --help
  /// Adds the command's options, which refer to `arguments`. Null: another program has the command.
  std::function<void(CLI::App& command, Arguments& arguments)> add_options = nullptr;
  /// Returns the exit status.
  std::function<int(const Arguments& arguments)> execute = nullptr;
  /// Whether the command's result is its output on the terminal, rather than files.
  bool prints_result = false;
  /// Returns the instructions (`--instructions`) with which earlier results were computed, if the
  /// command goes on with such, else an empty text. May be null.
  std::function<std::string(const Arguments& arguments)> instructions_before = nullptr;
};

/// What a command throws, before it writes anything, if it needs what only its other program has.
struct OtherProgramNeeded {};

/// Prepares streams, signals and environment of a process. Returns false if standard output is
/// closed.
bool prepare_process();

/// Runs the program `spoke`. Returns the exit status; every failure is reported on standard error.
int run_program(const std::vector<Command>& commands, int argc, char** argv);

/// Runs the program `spoke-NAME` of a command of that name, as run_program() would `spoke NAME`.
int run_program(const Command& command, int argc, char** argv);

}  // namespace spoke::cli
