// Makes threads that sleep until all are there, and ends them.

#include "graph/machine/thread_trial.h"

#include <atomic>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "spoke/error.h"

namespace spoke::graph {
namespace {

/// Threads that are all there until this ends.
class WaitingThreads {
 public:
  explicit WaitingThreads(int count) { threads_.reserve(static_cast<std::size_t>(count)); }
  WaitingThreads(const WaitingThreads&) = delete;
  WaitingThreads& operator=(const WaitingThreads&) = delete;
  ~WaitingThreads() {
    may_end_ = true;
    may_end_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void add_one() {
    threads_.emplace_back([this] { may_end_.wait(false); });
  }

 private:
  std::atomic<bool> may_end_{false};
  std::vector<std::thread> threads_;
};

}  // namespace

void try_threads(int threads) {
  if (threads <= 1) return;
  int made = 1;
  try {
    WaitingThreads others(threads - 1);
    for (; made < threads; ++made) others.add_one();
  } catch (const std::exception& error) {  // what a thread needs, or the memory to keep it
    throw InputError(std::to_string(threads) + " threads cannot be made here: the system refuses " +
                     "more than " + std::to_string(made) + " (" + error.what() + ")");
  }
}

}  // namespace spoke::graph
