// Starts `dot`, and ends it if it takes too long.

#include "engine/trace/graphviz.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

namespace spoke::trace {
namespace {

constexpr std::chrono::seconds kLongest{60};
constexpr int kNotFound = 127;  // what a spawned program's status is where there is none

/// Starts dot with its messages thrown away; errno's value, 0: started.
int start(const std::string& input, const std::string& output, pid_t& process) {
  std::string name = "dot", format = "-Tsvg", option = "-o", out = output, in = input;
  const std::array<char*, 6> words{name.data(), format.data(), option.data(),
                                   out.data(),  in.data(),     nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int fault = posix_spawnp(&process, name.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return fault;
}

/// The exit status; -1: ended otherwise, or ended here for being too slow.
int wait_for(pid_t process, bool& is_late) {
  const auto deadline = std::chrono::steady_clock::now() + kLongest;
  int status = 0;
  for (;;) {
    const pid_t ended = waitpid(process, &status, is_late ? 0 : WNOHANG);
    if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (ended < 0 && errno != EINTR) return -1;
    if (!is_late && std::chrono::steady_clock::now() > deadline) {
      is_late = true;
      kill(process, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace

std::string draw(const std::filesystem::path& dot, const std::filesystem::path& svg) {
  std::filesystem::path temporary = svg;
  temporary += ".tmp";
  pid_t process = 0;
  bool is_late = false;
  const int fault = start(std::filesystem::absolute(dot).string(),
                          std::filesystem::absolute(temporary).string(), process);
  if (fault != 0 && fault != ENOENT) return std::strerror(fault);
  const int status = fault != 0 ? kNotFound : wait_for(process, is_late);
  std::error_code error;
  if (status == 0) std::filesystem::rename(temporary, svg, error);
  if (status == 0 && !error) return {};
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  std::filesystem::remove(svg, ignored);  // one of an earlier trace would not belong to the others
  if (status == kNotFound) return "Graphviz is not installed (Debian: apt-get install graphviz)";
  if (is_late) return "Graphviz took longer than " + std::to_string(kLongest.count()) + " s";
  return error ? error.message() : "Graphviz failed";
}

}  // namespace spoke::trace
