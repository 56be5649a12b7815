#pragma once

// Options that several commands share.

#include <string>

#include "program/cli/arguments.h"

namespace CLI {
class App;
}

namespace spoke::cli {

// These options refer to `arguments`, which must outlive the command.

/// Adds SCENARIO, --set and --verbose.
void add_common(CLI::App& command, Arguments& arguments);
/// Adds an option that names a folder ("DIR") or a file ("FILE"). It refuses an empty name, which a
/// shell variable that is not set gives.
void add_path(CLI::App& command, const std::string& option, std::string& path,
              const std::string& text, const std::string& kind);
/// Adds --out and --force. `unless_given`: the default folder as --help describes it.
void add_out(CLI::App& command, Arguments& arguments, const std::string& unless_given);
/// Adds --force, of commands that write files.
void add_force(CLI::App& command, Arguments& arguments);
void add_integrator(CLI::App& command, Arguments& arguments);
/// Adds --instructions.
void add_instructions(CLI::App& command, Arguments& arguments);
/// Adds the options of commands that simulate: formulation, integrator, executor, threads and
/// window; refuses an executor that does not run on such threads.
void add_running(CLI::App& command, Arguments& arguments);

}  // namespace spoke::cli
