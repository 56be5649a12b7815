// Parses the number of steps, the time, the size of the buffer and numbers of threads.

#include "program/cli/trace_arguments.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <set>

#include "graph/executor.h"
#include "program/cli/number_option.h"
#include "program/cli/word_list.h"

namespace spoke::cli {
namespace {

constexpr std::int64_t kMostSteps = 100000;
constexpr double kMostBuffer = 65536.0;  // [MB]
constexpr double kLatest = 1e300;        // [s]

int parse_count(const std::string& text) {
  int count = 0;
  const char* const last = text.data() + text.size();
  const auto [end, fault] = std::from_chars(text.data(), last, count);
  if (fault != std::errc{} || end != last || count < 1 || count > graph::kMostThreads)
    throw CLI::ValidationError("--more-threads", "expected numbers from 1 to " +
                                                     std::to_string(graph::kMostThreads) +
                                                     ", separated by commas, got \"" + text + '"');
  return count;
}

/// Parses "1,2,4" into ascending order, each number once.
std::vector<int> parse_counts(const std::string& list) {
  std::set<int> counts;
  for (const std::string& word : split_words(list)) counts.insert(parse_count(word));
  return {counts.begin(), counts.end()};
}

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
  command
      .add_option_function<std::string>(
          "--more-threads",
          [&](const std::string& list) { arguments.more_threads = parse_counts(list); },
          "Numbers of threads on which the steps are simulated\n[1,2,4,8,16,32,64]")
      ->type_name("N,N,...");
}

}  // namespace spoke::cli
