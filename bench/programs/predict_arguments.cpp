// Parses the numbers of threads and the window.

#include "bench/programs/predict_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "engine/simulation.h"
#include "program/cli/number_option.h"
#include "program/cli/threads_option.h"

namespace spoke::cli {
namespace {

/// Parses "1,2,4" into ascending order, each number once.
std::vector<int> parse_counts(const std::string& list) {
  std::vector<int> counts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const graph::Threads threads = parse_threads_option(list.substr(begin, end - begin));
    if (threads.inner > 1)
      throw CLI::ValidationError("--threads",
                                 "executors with nested teams are not predicted, "
                                 "expected numbers, got " +
                                     graph::name_of(threads));
    counts.push_back(threads.outer);
    begin = end + 1;
  }
  std::sort(counts.begin(), counts.end());
  counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
  return counts;
}

}  // namespace

void add_predict_options(CLI::App& command, PredictArguments& arguments) {
  command
      .add_option_function<std::string>(
          "--threads", [&](const std::string& list) { arguments.threads = parse_counts(list); },
          "Numbers of threads to predict for [1,2,4,8,16,32,64];\n"
          "those that this machine has processors for are measured, too")
      ->type_name("N,N,...");
  command
      .add_option("--window", arguments.window,
                  "Steps of one run, for all executors alike\n"
                  "[as in a run: auto chooses, the others take 1 pass]")
      ->check(CLI::Range(1, kMostWindow))
      ->type_name("STEPS");
  CLI::Option* const ranks =
      command
          .add_option("--ranks", arguments.ranks,
                      "Numbers of processes to predict for, on several machines\n"
                      "(docs/machines.md), each of one thread")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->check(CLI::Range(1, 1000000))
          ->type_name("N,N,...");
  command
      .add_option_function<std::string>(
          "--latency",
          [&](const std::string& text) {
            arguments.latency =
                parse_number("--latency", text, 0.0, 1.0, "a number from 0 to 1 [s]");
          },
          "Of a message between processes\n"
          "[measured under mpirun -n 2, else 5e-6]")
      ->needs(ranks)
      ->type_name("SECONDS");
}

}  // namespace spoke::cli
