// The program "spoke": command line in, exit status out.

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "engine/cli/choose_instructions.h"
#include "engine/cli/commands.h"
#include "engine/cli/interruption.h"
#include "engine/cli/measure_child_command.h"
#include "engine/cli/parse_arguments.h"
#include "engine/cli/report.h"
#include "engine/cli/standard_streams.h"
#include "graph/execute/unbound_thread.h"
#include "graph/executor.h"
#include "models/error.h"

namespace {

using namespace spoke;

void start_logging(const cli::Arguments& arguments) {
  // Not as "spoke", where the library would hear it: the program says these things itself.
  spdlog::set_default_logger(spdlog::stderr_color_mt("program"));
  spdlog::set_pattern("[%Y-%m-%d %H:%M:%S.%e] [spoke] [%^%l%$] %v");
  const auto level = arguments.verbosity > 1    ? spdlog::level::debug
                     : arguments.verbosity == 1 ? spdlog::level::info
                                                : spdlog::level::warn;
  spdlog::set_level(arguments.quiet && arguments.verbosity == 0 ? spdlog::level::err : level);
}

int execute(const cli::Arguments& arguments) {
  switch (arguments.command) {
    case cli::Arguments::Command::run:
      return cli::run(arguments);
    case cli::Arguments::Command::check:
      return cli::check(arguments);
    case cli::Arguments::Command::compare:
      return cli::compare(arguments);
    case cli::Arguments::Command::predict:
      return cli::predict(arguments);
    case cli::Arguments::Command::reproduce:
      return cli::reproduce(arguments);
    case cli::Arguments::Command::trace:
      return cli::trace(arguments);
    case cli::Arguments::Command::find_static:
      return cli::find_static(arguments);
    case cli::Arguments::Command::find_modes:
      return cli::find_modes(arguments);
    case cli::Arguments::Command::find_campbell:
      return cli::find_campbell(arguments);
    case cli::Arguments::Command::linearize:
      return cli::linearize(arguments);
    case cli::Arguments::Command::study:
      return cli::study(arguments);
    case cli::Arguments::Command::none:
      break;
  }
  return 0;
}

int complain(const std::string& message, int status) {
  cli::print_error(cli::one_line(message));
  return status;
}

/// Whether a command's result is what it prints, rather than files.
bool prints_result(const cli::Arguments& arguments) {
  return arguments.command == cli::Arguments::Command::check ||
         arguments.command == cli::Arguments::Command::none;
}

/// The status of a command that ended with `status`, once what it printed has gone out. `is_lost`:
/// its result is what it prints, and there is no standard output.
int finish_output(int status, bool is_lost) {
  const char* reason = cli::flush_output();
  if (is_lost) reason = "it is closed";
  if (reason == nullptr) return status;
  cli::print_error(std::string("standard output: cannot be written: ") + reason);
  return status == 0 ? 2 : status;
}

}  // namespace

int main(int argc, char** argv) {
  const bool has_output = cli::open_standard_streams();
  // Spoke says itself how many threads there are, and LLVM's OpenMP runtime, which reads this when
  // it is first used, does not survive what is no number, or takes gigabytes.
  unsetenv("OMP_NUM_THREADS");
  cli::clean_up_on_signals();
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    // What `compare`, `predict` and `reproduce` start; no command for people, so it is in no help.
    if (!words.empty() && words[0] == cli::kMeasureChild) return cli::measure_child(words);
    const cli::Arguments arguments = cli::parse_arguments(words);
    cli::choose_instructions(arguments, argv);
    start_logging(arguments);
    // What binds OpenMP's threads (OMP_PROC_BIND and the like) is for OpenMP's executors alone.
    std::optional<graph::UnboundThread> unbound;
    if (!graph::is_openmp(arguments.options.executor)) unbound.emplace();
    const int status = execute(arguments);
    return finish_output(status, !has_output && prints_result(arguments));
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
