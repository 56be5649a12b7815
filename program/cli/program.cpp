// Parses a command line by CLI11, and runs what it asks for.

#include "program/cli/program.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>

#include "engine/support/source_commit.h"
#include "graph/execute/unbound_thread.h"
#include "graph/executor.h"
#include "models/error.h"
#include "models/reader/key_place.h"
#include "program/cli/choose_instructions.h"
#include "program/cli/file_guard.h"
#include "program/cli/help_texts.h"
#include "program/cli/interruption.h"
#include "program/cli/report.h"
#include "program/cli/standard_streams.h"

namespace spoke::cli {
namespace {

void start_logging(const Arguments& arguments) {
  // The logger is not named "spoke": the library would log to it, and the program reports these
  // things itself.
  spdlog::set_default_logger(spdlog::stderr_color_mt("program"));
  spdlog::set_pattern("[%Y-%m-%d %H:%M:%S.%e] [spoke] [%^%l%$] %v");
  const auto level = arguments.verbosity > 1    ? spdlog::level::debug
                     : arguments.verbosity == 1 ? spdlog::level::info
                                                : spdlog::level::warn;
  spdlog::set_level(arguments.quiet && arguments.verbosity == 0 ? spdlog::level::err : level);
}

int complain(const std::string& message, int status) {
  print_error(one_line(message));
  return status;
}

/// Flushes what a command printed. Returns its exit status, `status` unless output was lost.
/// `is_lost`: the command's result is its output, and standard output is closed.
int finish_output(int status, bool is_lost) {
  const char* reason = flush_output();
  if (is_lost) reason = "it is closed";
  if (reason == nullptr) return status;
  print_error(std::string("standard output: cannot be written: ") + reason);
  return status == 0 ? 2 : status;
}

/// Whether an argument is another KEY=VALUE behind --set, rather than an option or a file.
bool is_assignment(const std::string& argument) {
  const auto equals = argument.find('=');
  if (equals == std::string::npos || equals == 0 || argument[0] == '-') return false;
  return std::all_of(argument.begin(), argument.begin() + static_cast<std::ptrdiff_t>(equals),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; });
}

/// Turns "--set a=1 b=2" into "--set a=1 --set b=2", so that the list ends by itself before
/// SCENARIO.
std::vector<std::string> repeat_set(const std::vector<std::string>& arguments) {
  std::vector<std::string> repeated;
  bool in_list = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool first = i > 0 && arguments[i - 1] == "--set";
    in_list = first || (in_list && is_assignment(arguments[i]));
    if (in_list && !first) repeated.emplace_back("--set");
    repeated.push_back(arguments[i]);
  }
  return repeated;
}

/// Turns the name of a scenario file that begins with "-" into a path that does not.
std::string as_path(const std::string& argument) {
  const bool is_file = argument.starts_with('-') && argument.ends_with(".toml") &&
                       argument.find('=') == std::string::npos;
  return is_file ? "./" + argument : argument;
}

/// Returns "run, check or static".
std::string list_names(const std::vector<Command>& commands) {
  std::string text;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    if (k > 0) text += k + 1 == commands.size() ? " or " : ", ";
    text += commands[k].name;
  }
  return text;
}

/// Refuses words that begin with neither a command nor an option of the program. Returns the name
/// for messages.
std::string check_first(const std::vector<Command>& commands,
                        const std::vector<std::string>& words) {
  if (words.empty())
    throw InputError("spoke: no command, expected " + list_names(commands) + " (see spoke --help)");
  const std::string& first = words[0];
  for (const Command& command : commands)
    if (first == command.name) return "spoke " + first;
  if (first == "predict")
    throw InputError("spoke predict: is the section \"More threads\" of spoke trace now");
  if (first == "-h" || first == "--help" || first == "--version") return "spoke";
  throw InputError("spoke: unknown command \"" + first + "\", expected " + list_names(commands) +
                   " (see spoke --help)");
}

/// Returns "spoke VERSION (COMMIT)".
std::string describe_version() {
  std::string text = "spoke " SPOKE_VERSION;
  if (!source_commit().empty()) text += " (" + std::string(source_commit()) + ')';
  return text;
}

/// Returns the command that is asked for. Returns null if help or the version is asked for, which
/// it prints. Throws InputError.
const Command* parse(const std::vector<Command>& commands, const std::vector<std::string>& words,
                     Arguments& arguments) {
  CLI::App program("Spoke simulates flexible multibody systems; every step is a task graph.",
                   "spoke");
  program.set_version_flag("--version", describe_version(), "Print the version");
  program.footer(std::string(kProgramText) + '\n' + kStatusText);
  program.require_subcommand(1);
  for (const Command& command : commands) {
    CLI::App& subcommand = *program.add_subcommand(command.name, command.summary);
    if (command.add_options) command.add_options(subcommand, arguments);
  }
  const std::string name = check_first(commands, words);
  std::vector<std::string> reversed = repeat_set(words);
  std::transform(reversed.begin(), reversed.end(), reversed.begin(), as_path);
  std::reverse(reversed.begin(), reversed.end());
  try {
    program.parse(reversed);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    program.exit(help, text, text);
    print(text.str());
    return nullptr;
  } catch (const CLI::ExtrasError&) {
    std::vector<std::string> extras = program.remaining(true);
    std::erase(extras, "--");
    throw InputError(name + ": unexpected argument " + extras.front() + " (see " + name +
                     " --help)");
  } catch (const CLI::ParseError& error) {
    throw InputError(name + ": " + error.what() + " (see " + name + " --help)");
  }
  return &*std::find_if(commands.begin(), commands.end(),
                        [&](const Command& command) { return words[0] == command.name; });
}

int execute(const Command& command, const Arguments& arguments, char** argv) {
  const auto before = [&] {
    return command.instructions_before ? command.instructions_before(arguments) : std::string();
  };
  choose_instructions(arguments.instructions, before, argv);
  start_logging(arguments);
  if (arguments.replaces_other_kinds) let_replace_other_kinds();
  // Variables that bind OpenMP's threads (such as OMP_PROC_BIND) hold for OpenMP's executors alone.
  std::optional<graph::UnboundThread> unbound;
  if (!graph::is_openmp(arguments.options.executor)) unbound.emplace();
  try {
    return command.execute(arguments);
  } catch (const InputError& error) {
    // An error in an override begins with it, and is in no file.
    const bool is_placed = error.place().key.empty() || !error.place().file.empty() ||
                           std::string_view(error.what()).starts_with("--set ");
    if (is_placed || arguments.scenario.empty()) throw;
    throw place_in_file(error, arguments.scenario, arguments.overrides);
  }
}

/// Returns the program of a command, "spoke-study".
std::string program_of(const Command& command) {
  return std::string("spoke-") + (command.program ? command.program : command.name);
}

/// Has the script ./spoke, by which this program was started, build another one. Returns whether
/// there is such a script, and nothing went wrong.
bool build_program(const std::string& name) {
  const char* script = std::getenv("SPOKE_SCRIPT");
  if (!script) return true;
  const pid_t child = fork();
  if (child == 0) {
    execl(script, script, "--build", name.c_str(), nullptr);
    _exit(127);
  }
  int status = 1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Replaces this process by the program beside it that has a command; `argv`: the words of this
/// process, ended by a null pointer. Returns only if that cannot be started, with the exit status.
int start_program(const Command& command, char** argv) {
  const std::string name = program_of(command), called_as = std::string("spoke ") + command.name;
  if (!build_program(name)) return complain(called_as + ": " + name + " could not be built", 2);
  std::error_code none;
  const auto file = std::filesystem::read_symlink("/proc/self/exe", none).parent_path() / name;
  std::string called = file.string();
  std::vector<char*> words = {called.data()};
  for (char** word = argv + (command.program ? 1 : 2); *word; ++word) words.push_back(*word);
  words.push_back(nullptr);
  execv(called.c_str(), words.data());
  const std::string reason = std::strerror(errno);
  return complain(called_as + ": cannot start " + called + ": " + reason +
                      ", expected the program " + name +
                      " beside spoke (it is built by the target of this name)",
                  2);
}

int run_words(const std::vector<Command>& commands, const std::vector<std::string>& words,
              char** argv) {
  const bool has_output = prepare_process();
  const Command* command = nullptr;
  try {
    Arguments arguments;
    command = parse(commands, words, arguments);
    const int status = command ? execute(*command, arguments, argv) : 0;
    return finish_output(status, !has_output && (!command || command->prints_result));
  } catch (const OtherProgramNeeded&) {
    return start_program(*command, argv);
  } catch (const InputError& error) {
    return complain(error.what(), 2);
  } catch (const DivergenceError& error) {
    return complain(error.what(), 3);
  } catch (const std::bad_alloc&) {
    return complain("spoke: the model does not fit into this machine's memory", 2);
  } catch (const std::exception& error) {
    return complain(std::string("spoke: internal error: ") + error.what(), 1);
  }
}

}  // namespace

bool prepare_process() {
  const bool has_output = open_standard_streams();
  // Spoke sets the number of threads itself. LLVM's OpenMP runtime reads this variable at its first
  // use, and fails or takes gigabytes if its value is no number.
  unsetenv("OMP_NUM_THREADS");
  clean_up_on_signals();
  guard_files();
  return has_output;
}

int run_program(const std::vector<Command>& commands, int argc, char** argv) {
  if (argc > 1)
    for (const Command& command : commands)
      if (!command.execute && std::string(argv[1]) == command.name)
        return start_program(command, argv);
  return run_words(commands, {argv + 1, argv + argc}, argv);
}

int run_program(const Command& command, int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words != std::vector<std::string>{"--version"}) words.insert(words.begin(), command.name);
  return run_words({command}, words, argv);
}

}  // namespace spoke::cli
