// Parses the number of steps, the time and the size of the buffer.

#include "program/cli/trace_arguments.h"

#include <CLI/CLI.hpp>
#include <cstdint>

#include "program/cli/number_option.h"

namespace spoke::cli {
namespace {

constexpr std::int64_t kMostSteps = 100000;
constexpr double kMostBuffer = 65536.0;  // [MB]
constexpr double kLatest = 1e300;        // [s]

}  // namespace

void add_trace_options(CLI::App& command, TraceArguments& arguments) {
  command.add_option("--steps", arguments.steps, "Steps to record [20, or all if there are fewer]")
      ->check(CLI::Range(std::int64_t{1}, kMostSteps))
      ->type_name("K");
  command
      .add_option_function<std::string>(
          "--from",
          [&](const std::string& text) {
            arguments.from = parse_number("--from", text, 0.0, kLatest, "a time in s, 0 or more");
          },
          "Simulated time at which recording begins, in s [0]; the executor\n"
          "auto chooses on the way there")
      ->type_name("TIME");
  command
      .add_option_function<std::string>(
          "--buffer",
          [&](const std::string& text) {
            arguments.buffer_mb =
                parse_number("--buffer", text, 1.0, kMostBuffer, "1 to 65536 megabytes");
          },
          "Memory for the recording; steps that do not fit are left out [256]")
      ->type_name("MB");
}

}  // namespace spoke::cli
