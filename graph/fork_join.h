#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace spoke::graph {

/// How long a thread spins before it parks.
using SpinTime = std::chrono::nanoseconds;

/// Tells the processor that the thread is spinning.
inline void relax_processor() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Waits until `ready(value)` holds and returns that value: spins for up to `spin_time`, then parks
/// until notified. Who makes it ready must notify.
template <class Ready>
std::uint32_t wait_until(const std::atomic<std::uint32_t>& value, SpinTime spin_time, Ready ready) {
  using Clock = std::chrono::steady_clock;
  constexpr int looks_per_time = 32;  // reading the clock costs as much as a few looks
  std::uint32_t seen = value.load(std::memory_order_acquire);
  if (spin_time > SpinTime::zero() && !ready(seen)) {
    const auto end = Clock::now() + spin_time;
    do {
      for (int look = 0; look < looks_per_time && !ready(seen); ++look) {
        relax_processor();
        seen = value.load(std::memory_order_acquire);
      }
    } while (!ready(seen) && Clock::now() < end);
  }
  while (!ready(seen)) {
    value.wait(seen, std::memory_order_acquire);
    seen = value.load(std::memory_order_acquire);
  }
  return seen;
}

/// Where the first thread of a team hands work to the others and waits for them. Between two works
/// the others wait, so that the first may do alone what no other may do meanwhile.
template <class Work>
class ForkJoin {
 public:
  /// For the first thread, before its first fork: how many others take part.
  void set_workers(int workers) { workers_ = static_cast<std::uint32_t>(workers); }
  void set_spin_time(SpinTime spin_time) { spin_time_ = spin_time; }

  /// For the first thread: lets the others work. They end at a null pointer; else join() follows.
  void fork(const Work* work) {
    if (workers_ == 0) return;
    work_ = work;
    pending_.store(workers_, std::memory_order_relaxed);
    forks_.fetch_add(1, std::memory_order_release);
    forks_.notify_all();
  }
  /// For the first thread: returns when all others are done.
  void join() {
    wait_until(pending_, spin_time_, [](std::uint32_t pending) { return pending == 0; });
  }

  /// For each of the others: `work(const Work&)` of every fork until the last one.
  template <class Function>
  void serve(Function&& work) {
    for (std::uint32_t seen = 0;;) {
      seen = wait_until(forks_, spin_time_, [seen](std::uint32_t forks) { return forks != seen; });
      if (work_ == nullptr) return;
      work(*work_);
      if (pending_.fetch_sub(1, std::memory_order_acq_rel) == 1) pending_.notify_one();
    }
  }

 private:
  static constexpr std::size_t kCacheLine = 64;

  // What the first thread writes and what the others write are in cache lines of their own.
  alignas(kCacheLine) std::atomic<std::uint32_t> forks_{0};
  const Work* work_ = nullptr;
  std::uint32_t workers_ = 0;
  SpinTime spin_time_{0};
  alignas(kCacheLine) std::atomic<std::uint32_t> pending_{0};
};

}  // namespace spoke::graph
