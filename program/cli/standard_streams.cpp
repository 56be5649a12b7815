// Writes by calls that neither throw nor raise a signal: what a command prints never keeps it from
// writing its files.

#include "program/cli/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

namespace spoke::cli {
namespace {

int output_error = 0;  // errno's value when standard output first took no more; 0: it took all

void note_error(bool is_written) {
  if (!is_written && output_error == 0) output_error = errno;
}

}  // namespace

bool open_standard_streams() {
  const bool has_output = fcntl(STDOUT_FILENO, F_GETFD) >= 0;
  int descriptor = STDIN_FILENO;
  // Each open() takes the lowest free number, until that is none of the three.
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDWR);
  if (descriptor >= 0) close(descriptor);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return has_output;
}

void print(std::string_view text) {
  note_error(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void print_error(std::string_view line) {
  flush_output();
  const std::string text = std::string(line) + '\n';  // in one piece, for it has no buffer
  std::fwrite(text.data(), 1, text.size(), stderr);
}

const char* flush_output() {
  note_error(std::fflush(stdout) == 0);
  return output_error == 0 ? nullptr : std::strerror(output_error);
}

}  // namespace spoke::cli
