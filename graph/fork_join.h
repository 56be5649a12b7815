#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>

#include "graph/parking.h"

namespace spoke::graph {

/// Tells the processor that the thread is spinning.
inline void relax_processor() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// How the threads of an executor wait for one another before they park.
class Patience {
 public:
  /// `shares_processors`: there are more of them than processors, so that who waits must let the
  /// others run.
  explicit Patience(bool shares_processors) : shares_processors_(shares_processors) {}

  /// Looks, for some time at most, until `ready(look())`; the last value seen. Returns at once
  /// where waiting like this does not pay.
  template <class Look, class Ready>
  std::uint32_t wait(Look look, Ready ready) {
    const std::uint32_t seen = look();
    if (ready(seen)) return seen;
    return shares_processors_ ? yield(seen, look, ready) : spin(seen, look, ready);
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Of the order of what it costs to park and to be woken, so that neither choice costs twice the
  // other.
  static constexpr std::chrono::microseconds kTime{50};
  // No thread of a small step is that long at work.
  static constexpr std::chrono::microseconds kOthersWork{100};
  // How many times as long as other programs took, threads then park at once; and how long at most,
  // since a program that was halted has not seen others at work.
  static constexpr int kGiveUp = 20;
  static constexpr std::chrono::seconds kLongestGiveUp{1};

  template <class Look, class Ready>
  static std::uint32_t spin(std::uint32_t seen, Look look, Ready ready) {
    constexpr int looks_per_time = 32;  // reading the clock costs as much as a few looks
    const auto end = Clock::now() + kTime;
    do {
      for (int k = 0; k < looks_per_time && !ready(seen); ++k) {
        relax_processor();
        seen = look();
      }
    } while (!ready(seen) && Clock::now() < end);
    return seen;
  }

  // Where other programs compute, each yield costs a time slice of theirs, milliseconds.
  template <class Look, class Ready>
  std::uint32_t yield(std::uint32_t seen, Look look, Ready ready) {
    Clock::time_point now = Clock::now();
    if (now.time_since_epoch().count() < yields_from_.load(std::memory_order_relaxed)) return seen;
    const auto end = now + kTime;
    do {
      const Clock::time_point before = now;
      std::this_thread::yield();
      seen = look();
      now = Clock::now();
      if (now - before > kOthersWork) give_up(now, now - before);
    } while (!ready(seen) && now < end);
    return seen;
  }

  void give_up(Clock::time_point now, Clock::duration others_took) {
    const auto until = now + std::min<Clock::duration>(kGiveUp * others_took, kLongestGiveUp);
    yields_from_.store(until.time_since_epoch().count(), std::memory_order_relaxed);
  }

  const bool shares_processors_;
  std::atomic<Clock::rep> yields_from_{0};  // on the clock; parks at once until then
};

/// A number that threads wait for.
class AwaitedNumber {
 public:
  /// While nobody waits.
  void set(std::uint32_t value) { value_.store(value, std::memory_order_relaxed); }
  /// What was written before is seen by whom it makes ready. The value after it.
  std::uint32_t add(std::uint32_t change) { return value_.fetch_add(change) + change; }
  /// Behind add(), if it may have made somebody ready.
  void wake() {
    // Who parks counts itself first and looks at the value then; here it is the other way round, so
    // that one of the two sees the other.
    if (parked_.load() > 0) unpark_all(value_);
  }

  /// Waits until `ready(value)` holds and returns that value: with patience, then parks until
  /// woken.
  template <class Ready>
  std::uint32_t wait_until(Patience& patience, Ready ready) {
    std::uint32_t seen = patience.wait([this] { return look(); }, ready);
    if (ready(seen)) return seen;
    parked_.fetch_add(1);
    for (seen = value_.load(); !ready(seen); seen = value_.load()) park(value_, seen);
    parked_.fetch_sub(1, std::memory_order_relaxed);
    return seen;
  }

 private:
  std::uint32_t look() const { return value_.load(std::memory_order_acquire); }

  std::atomic<std::uint32_t> value_{0};
  std::atomic<std::uint32_t> parked_{0};  // how many threads
};

/// Where the first thread of a team hands work to the others and waits for them. Between two works
/// the others wait, so that the first may do alone what no other may do meanwhile.
template <class Work>
class ForkJoin {
 public:
  explicit ForkJoin(Patience& patience) : patience_(patience) {}

  /// For the first thread, before its first fork: how many others take part.
  void set_workers(int workers) { workers_ = static_cast<std::uint32_t>(workers); }

  /// For the first thread: lets the others work. They end at a null pointer; else join() follows.
  void fork(const Work* work) {
    if (workers_ == 0) return;
    work_ = work;
    pending_.set(workers_);
    forks_.add(1);
    forks_.wake();
  }
  /// For the first thread: returns when all others are done.
  void join() {
    pending_.wait_until(patience_, [](std::uint32_t pending) { return pending == 0; });
  }

  /// For each of the others: `work(const Work&)` of every fork until the last one.
  template <class Function>
  void serve(Function&& work) {
    for (std::uint32_t seen = 0;;) {
      seen = forks_.wait_until(patience_, [seen](std::uint32_t forks) { return forks != seen; });
      if (work_ == nullptr) return;
      work(*work_);
      if (pending_.add(kMinusOne) == 0) pending_.wake();
    }
  }

 private:
  static constexpr auto kMinusOne = static_cast<std::uint32_t>(-1);

  static constexpr std::size_t kCacheLine = 64;

  // What the first thread writes and what the others write are in cache lines of their own.
  alignas(kCacheLine) AwaitedNumber forks_;
  const Work* work_ = nullptr;
  std::uint32_t workers_ = 0;
  Patience& patience_;
  alignas(kCacheLine) AwaitedNumber pending_;
};

}  // namespace spoke::graph
