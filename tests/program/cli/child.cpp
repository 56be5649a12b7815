#include "tests/program/cli/child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

namespace fs = std::filesystem;

namespace {

/// In the new process: nothing here may allocate.
[[noreturn]] void execute(char* const* words, const char* folder, const char* errors,
                          std::uint64_t most_bytes) {
  const int nothing = open("/dev/null", O_RDWR);
  const int error_file = open(errors, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (chdir(folder) != 0 || dup2(nothing, 0) < 0 || dup2(nothing, 1) < 0 || dup2(error_file, 2) < 0)
    _exit(99);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) std::signal(signal, SIG_DFL);
  if (most_bytes > 0) {
    const rlimit limit{most_bytes, most_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  execv(words[0], words);
  _exit(99);
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const WorkFolder& folder,
             std::uint64_t most_bytes) {
  std::vector<std::string> words = {SPOKE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const std::string place = folder.path().string(), errors = (texts_.path() / "err").string();
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("cannot start a process");
  if (process_ == 0) execute(pointers.data(), place.c_str(), errors.c_str(), most_bytes);
}

Child::~Child() {
  if (has_ended_) return;
  send(SIGKILL);
  waitpid(process_, &how_, 0);
}

void Child::send(int signal) const { kill(process_, signal); }

bool Child::is_running() {
  if (!has_ended_) has_ended_ = waitpid(process_, &how_, WNOHANG) == process_;
  return !has_ended_;
}

ChildEnded Child::wait() {
  if (!has_ended_) waitpid(process_, &how_, 0);
  has_ended_ = true;
  return {WIFEXITED(how_) ? WEXITSTATUS(how_) : -1, WIFSIGNALED(how_) ? WTERMSIG(how_) : 0,
          file_text(texts_.path() / "err")};
}

std::uint64_t size_of(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return error ? 0 : size;
}

void sleep_seconds(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}
