#pragma once

// Options that several commands have in common.

#include <string>

#include "program/cli/arguments.h"

namespace CLI {
class App;
}

namespace spoke::cli {

// Options that several commands have. They refer to `arguments`, which must outlive the command.

/// SCENARIO, --set and --verbose.
void add_common(CLI::App& command, Arguments& arguments);
/// An option that names a folder ("DIR") or a file ("FILE"). An empty name is refused: it is what a
/// variable of the shell gives that is not set.
void add_path(CLI::App& command, const std::string& option, std::string& path,
              const std::string& text, const std::string& kind);
/// --out; `unless_given` is what --help says of the folder otherwise.
void add_out(CLI::App& command, Arguments& arguments, const std::string& unless_given);
void add_formulation(CLI::App& command, Arguments& arguments);
void add_integrator(CLI::App& command, Arguments& arguments);
/// --instructions.
void add_instructions(CLI::App& command, Arguments& arguments);
/// What runs the steps, of commands that simulate: formulation, integrator, executor, threads and
/// window.
void add_running(CLI::App& command, Arguments& arguments);

}  // namespace spoke::cli
