// The program "spoke": command line in, exit status out.

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <optional>

#include "engine/cli/check_command.h"
#include "engine/cli/compare_command.h"
#include "engine/cli/measure_child_command.h"
#include "engine/cli/parse_arguments.h"
#include "engine/cli/predict_command.h"
#include "engine/cli/report.h"
#include "engine/cli/reproduce_command.h"
#include "engine/cli/run_command.h"
#include "engine/cli/trace_command.h"
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
    case cli::Arguments::Command::none:
      break;
  }
  return 0;
}

int complain(const std::string& message, int status) {
  std::fflush(stdout);
  fmt::print(stderr, "{}\n", cli::one_line(message));
  return status;
}

/// The status of a command that ended with `status`, once what it printed has gone out.
int finish_output(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  const char* reason = std::strerror(errno);
  fmt::print(stderr, "standard output: cannot be written: {}\n", reason);
  return status == 0 ? 2 : status;
}

}  // namespace

int main(int argc, char** argv) {
  // A file beyond the process's limit is then an error of writing, with its message.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    // What `compare`, `predict` and `reproduce` start; no command for people, so it is in no help.
    if (!words.empty() && words[0] == cli::kMeasureChild) return cli::measure_child(words);
    const cli::Arguments arguments = cli::parse_arguments(words);
    start_logging(arguments);
    // What binds OpenMP's threads (OMP_PROC_BIND and the like) is for OpenMP's executors alone.
    std::optional<graph::UnboundThread> unbound;
    if (!graph::is_openmp(arguments.options.executor)) unbound.emplace();
    return finish_output(execute(arguments));
  } catch (const InputError& error) {
    return complain(error.what(), 2);
  } catch (const DivergenceError& error) {
    return complain(error.what(), 3);
  } catch (const std::bad_alloc&) {
    return complain("spoke: the model does not fit into this machine's memory", 2);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return finish_output(0);
    return complain(std::string("spoke: internal error: ") + error.what(), 1);
  }
}
