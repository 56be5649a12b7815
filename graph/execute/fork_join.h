#pragma once

// Hands work to a team of threads and waits for it, for OpenMP scheme 1.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "graph/machine/parking.h"

namespace spoke::graph {

/// Tells the processor that the thread is spinning.
inline void relax_processor() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// A number that threads wait for.
class AwaitedNumber {
 public:
  /// Sets the number. Precondition: nobody waits.
  void set(std::uint32_t value) { value_.store(value, std::memory_order_relaxed); }
  /// Adds to the number and returns the new value. Threads that this makes ready see all earlier
  /// writes.
  std::uint32_t add(std::uint32_t change) { return value_.fetch_add(change) + change; }
  /// Wakes the waiting threads, after an add() that may have made one ready.
  void wake() {
    // A thread that parks counts itself first and then looks at the value; here the order is
    // reversed, so that one of the two sees the other.
    if (parked_.load() > 0) unpark_all(value_);
  }

  /// Waits until `ready(value)` holds and returns that value: spins for some time, then parks until
  /// woken.
  template <class Ready>
  std::uint32_t wait_until(Ready ready) {
    std::uint32_t seen = spin_until(ready);
    if (ready(seen)) return seen;
    parked_.fetch_add(1);
    for (seen = value_.load(); !ready(seen); seen = value_.load()) park(value_, seen);
    parked_.fetch_sub(1, std::memory_order_relaxed);
    return seen;
  }

 private:
  // About the cost of parking and being woken, so that neither choice costs twice the other.
  static constexpr std::chrono::microseconds kSpinTime{50};

  std::uint32_t look() const { return value_.load(std::memory_order_acquire); }

  // Spins until `ready(value)` holds, or for some time. Returns the last value seen.
  template <class Ready>
  std::uint32_t spin_until(Ready ready) const {
    using Clock = std::chrono::steady_clock;
    constexpr int looks_per_time = 32;  // reading the clock costs as much as a few looks
    std::uint32_t seen = look();
    if (ready(seen)) return seen;
    const auto end = Clock::now() + kSpinTime;
    do {
      for (int k = 0; k < looks_per_time && !ready(seen); ++k) {
        relax_processor();
        seen = look();
      }
    } while (!ready(seen) && Clock::now() < end);
    return seen;
  }

  std::atomic<std::uint32_t> value_{0};
  std::atomic<std::uint32_t> parked_{0};  // number of threads
};

/// A place where the first thread of a team hands work to the others and waits for them. Between
/// two works the others wait, so that the first may do alone what no other may do meanwhile.
template <class Work>
class ForkJoin {
 public:
  /// Sets how many other threads take part; for the first thread, before its first fork.
  void set_workers(int workers) { workers_ = static_cast<std::uint32_t>(workers); }

  /// Lets the others work; for the first thread. They end at a null pointer; otherwise join()
  /// follows.
  void fork(const Work* work) {
    if (workers_ == 0) return;
    work_ = work;
    pending_.set(workers_);
    forks_.add(1);
    forks_.wake();
  }
  /// Returns when all others are done; for the first thread.
  void join() {
    pending_.wait_until([](std::uint32_t pending) { return pending == 0; });
  }

  /// Calls `work(const Work&)` for every fork until the last one; for each of the others.
  template <class Function>
  void serve(Function&& work) {
    for (std::uint32_t seen = 0;;) {
      seen = forks_.wait_until([seen](std::uint32_t forks) { return forks != seen; });
      if (work_ == nullptr) return;
      work(*work_);
      if (pending_.add(kMinusOne) == 0) pending_.wake();
    }
  }

 private:
  static constexpr auto kMinusOne = static_cast<std::uint32_t>(-1);

  static constexpr std::size_t kCacheLine = 64;

  // The number that the first thread writes and the one that the others write have cache lines of
  // their own.
  alignas(kCacheLine) AwaitedNumber forks_;
  const Work* work_ = nullptr;
  std::uint32_t workers_ = 0;
  alignas(kCacheLine) AwaitedNumber pending_;
};

}  // namespace spoke::graph
