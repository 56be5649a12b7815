// Writes the line, if stderr is a terminal.

#include "engine/cli/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace spoke::cli {

void show_progress(const std::string& text) {
  static const bool shown = isatty(STDERR_FILENO) == 1;
  if (!shown) return;
  std::fputs(("\r" + text + "\033[K").c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace spoke::cli
