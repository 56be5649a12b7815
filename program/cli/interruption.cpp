// The handlers of SIGINT, SIGTERM and SIGHUP.

#include "program/cli/interruption.h"

#include <atomic>

#include "engine/output_file.h"

namespace spoke::cli {
namespace {

constexpr std::array kEnding{SIGINT, SIGTERM, SIGHUP};

std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free);  // so a handler may touch it

extern "C" void end_by_signal(int signal) {
  remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // delivered when this handler returns
}

extern "C" void note_signal(int signal) {
  if (noted != 0) return end_by_signal(signal);
  noted = signal;
}

void handle(int signal, void (*handler)(int), struct sigaction& before) {
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
  noted = 0;
  for (std::size_t k = 0; k < kEnding.size(); ++k) handle(kEnding[k], note_signal, before_[k]);
}

Interruption::~Interruption() {
  for (std::size_t k = 0; k < kEnding.size(); ++k) sigaction(kEnding[k], &before_[k], nullptr);
}

int Interruption::signal() { return noted; }

void clean_up_on_signals() {
  struct sigaction before {};
  for (const int signal : kEnding) handle(signal, end_by_signal, before);
}

std::string name_of_signal(int signal) {
  if (signal == SIGHUP) return "SIGHUP";
  return signal == SIGINT ? "SIGINT" : "SIGTERM";
}

}  // namespace spoke::cli
