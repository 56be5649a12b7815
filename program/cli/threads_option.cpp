// Parses one number, or two with an x between them.

#include "program/cli/threads_option.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>

#include "models/error.h"

namespace spoke::cli {

using graph::kMostThreads;

graph::Threads parse_threads(const std::string& text) {
  const auto fail = [&] {
    return InputError("expected a number from 1 to " + std::to_string(kMostThreads) +
                      ", or two as in 3x2, got " + text);
  };
  const auto number = [&](std::string_view digits) {
    int value = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (fault != std::errc{} || end != digits.data() + digits.size() || value < 1) throw fail();
    return value;
  };
  const auto cross = text.find('x');
  const int outer = number(std::string_view(text).substr(0, cross));
  const int inner =
      cross == std::string::npos ? 1 : number(std::string_view(text).substr(cross + 1));
  if (outer > kMostThreads || inner > kMostThreads / outer) throw fail();
  return {outer, inner};
}

graph::Threads parse_threads_option(const std::string& text) {
  try {
    return parse_threads(text);
  } catch (const InputError& error) {
    throw CLI::ValidationError("--threads", error.what());
  }
}

}  // namespace spoke::cli
