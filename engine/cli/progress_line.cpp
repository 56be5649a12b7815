// Writes the line, if stderr is a terminal.

#include "engine/cli/progress_line.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstdio>

namespace spoke::cli {

void show_progress(const std::string& text) {
  static const bool shown = isatty(STDERR_FILENO) == 1;
  if (!shown) return;
  fmt::print(stderr, "\r{}\033[K", text);
  std::fflush(stderr);
}

}  // namespace spoke::cli
