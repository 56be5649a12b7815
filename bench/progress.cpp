// Writes the line of progress.

#include "bench/progress.h"

#include <unistd.h>

#include <cstdio>

namespace spoke::bench {

void show_progress(const std::string& text) {
  static const bool shown = isatty(STDERR_FILENO) == 1;
  if (!shown) return;
  std::fprintf(stderr, "\r%s\033[K", text.c_str());
  std::fflush(stderr);
}

}  // namespace spoke::bench
