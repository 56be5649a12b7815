// Starts the process, sends it lines, waits for its answers, and ends it.

#include "bench/compare/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

namespace spoke::compare {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// fork() without the handlers that libraries have for it: that of LLVM's OpenMP runtime, once the
/// runtime has begun, can end the child.
pid_t fork_plainly() {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
  return _Fork();
#else
  return fork();
#endif
}

/// The child's side of fork_plainly(): calls nothing but system calls.
[[noreturn]] void become(const char* program, char* const* arguments, char* const* environment,
                         int socket, pid_t parent) {
  // A group of its own: what a terminal sends to the parent's group must not wake or stop it.
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent ended before it could be followed
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (dup2(socket, STDIN_FILENO) >= 0 && dup2(socket, STDOUT_FILENO) >= 0 &&
      dup2(nowhere, STDERR_FILENO) >= 0)
    execve(program, arguments, environment);
  _exit(127);
}

}  // namespace

Child::Child(const Command& command) {
  std::vector<std::string> words{command.program};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  const std::vector<char*> arguments = pointers_to(words);
  const std::vector<char*> environment = pointers_to(command.environment);
  // A pair of sockets rather than pipes: writing to a child that has ended raises no signal.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("socketpair");
  const pid_t parent = getpid();
  process_ = fork_plainly();
  if (process_ == 0)
    become(command.program.c_str(), arguments.data(), environment.data(), ends[1], parent);
  const int error = errno;
  close(ends[1]);
  socket_ = ends[0];
  if (process_ < 0) {
    close(socket_);
    errno = error;
    fail("fork");
  }
  send_text(command.input);
}

Child::~Child() {
  if (process_ > 0) kill(process_, SIGKILL);
  while (process_ > 0) reap(0);
  close(socket_);
}

void Child::reap(int options) {
  int status = 0;
  const pid_t changed = waitpid(process_, &status, options);
  if (changed < 0 && errno == EINTR) return;
  if (changed < 0 || (changed > 0 && !WIFSTOPPED(status))) process_ = -1;
}

void Child::send(const std::string& line) { send_text(line + '\n'); }

void Child::send_text(const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t count = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

Answer Child::receive(double seconds_allowed) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds_allowed);
  for (;;) {
    const auto end = received_.find('\n');
    if (end != std::string::npos) {
      Answer answer{Answer::Kind::line, received_.substr(0, end)};
      received_.erase(0, end + 1);
      return answer;
    }
    const std::chrono::duration<double, std::milli> left = deadline - Clock::now();
    if (left.count() <= 0.0) return {Answer::Kind::late, ""};
    pollfd wanted{socket_, POLLIN, 0};
    if (poll(&wanted, 1, static_cast<int>(std::min(left.count() + 1.0, 1e6))) <= 0) continue;
    std::array<char, 512> buffer;
    const ssize_t count = recv(socket_, buffer.data(), buffer.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return {Answer::Kind::ended, ""};
    received_.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void Child::halt() {
  if (process_ < 0) return;
  kill(process_, SIGSTOP);
  reap(WUNTRACED);  // returns when it has stopped
}

void Child::go_on() {
  if (process_ > 0) kill(process_, SIGCONT);
}

}  // namespace spoke::compare
