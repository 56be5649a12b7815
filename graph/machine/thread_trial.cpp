// Makes threads that sleep until all are there, and ends them.

#include "graph/machine/thread_trial.h"

#include <pthread.h>

#include <atomic>
#include <cstring>
#include <string>
#include <vector>

#include "spoke/error.h"

namespace spoke::graph {
namespace {

/// Threads that are all there until this ends.
class WaitingThreads {
 public:
  WaitingThreads(int most, std::size_t stack) {
    threads_.reserve(static_cast<std::size_t>(most));
    pthread_attr_init(&attributes_);
    // A stack that is too small is no stack size to the runtimes, either.
    if (stack > 0) pthread_attr_setstacksize(&attributes_, stack);
  }
  WaitingThreads(const WaitingThreads&) = delete;
  WaitingThreads& operator=(const WaitingThreads&) = delete;
  ~WaitingThreads() {
    may_end_ = true;
    may_end_.notify_all();
    for (const pthread_t thread : threads_) pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes_);
  }

  /// Returns errno's value; 0: the thread was made.
  int add_one() {
    pthread_t thread{};
    const int error = pthread_create(&thread, &attributes_, wait, &may_end_);
    if (error == 0) threads_.push_back(thread);
    return error;
  }

 private:
  static void* wait(void* may_end) {
    static_cast<std::atomic<bool>*>(may_end)->wait(false);
    return nullptr;
  }

  pthread_attr_t attributes_{};
  std::atomic<bool> may_end_{false};
  std::vector<pthread_t> threads_;
};

}  // namespace

void try_threads(int threads, std::size_t stack) {
  if (threads <= 1) return;
  WaitingThreads others(threads - 1, stack);
  for (int made = 1; made < threads; ++made) {
    const int error = others.add_one();
    if (error == 0) continue;
    std::string text = std::to_string(threads) +
                       " threads cannot be made here: the system refuses " + "more than " +
                       std::to_string(made) + " (" + std::strerror(error) + ")";
    if (stack > 0) text += ", each with a stack of " + std::to_string(stack) + " bytes";
    throw InputError(text);
  }
}

}  // namespace spoke::graph
