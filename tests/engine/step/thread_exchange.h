#pragma once

// Processes that share a model's subsystems, as threads of a test.

#include <algorithm>
#include <barrier>
#include <cstddef>
#include <exception>
#include <functional>
#include <span>
#include <thread>
#include <vector>

#include "engine/exchange.h"

namespace spoke::test {

/// Memory that the threads of a test share.
struct ThreadGroup {
  explicit ThreadGroup(int ranks) : barrier(ranks), count(ranks) {}
  std::barrier<> barrier;
  int count;
  std::vector<std::byte> all;
};

class ThreadExchange : public Exchange {
 public:
  ThreadExchange(int rank, ThreadGroup& group) : rank_(rank), group_(group) {}
  int rank() const override { return rank_; }
  int count() const override { return group_.count; }
  void share(std::span<std::byte> all, std::span<const std::size_t> first) noexcept override {
    if (rank_ == 0) group_.all.resize(all.size());
    group_.barrier.arrive_and_wait();
    const auto own = static_cast<std::size_t>(rank_);
    std::copy(all.begin() + static_cast<std::ptrdiff_t>(first[own]),
              all.begin() + static_cast<std::ptrdiff_t>(first[own + 1]),
              group_.all.begin() + static_cast<std::ptrdiff_t>(first[own]));
    group_.barrier.arrive_and_wait();
    std::copy(group_.all.begin(), group_.all.end(), all.begin());
    group_.barrier.arrive_and_wait();
  }

 private:
  int rank_;
  ThreadGroup& group_;
};

/// Lets each of some processes do something at once. What one throws is thrown.
inline void on_ranks(int count, const std::function<void(ThreadExchange&)>& work) {
  ThreadGroup group(count);
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count));
  std::vector<std::thread> threads;
  for (int rank = 0; rank < count; ++rank)
    threads.emplace_back([&, rank] {
      ThreadExchange exchange(rank, group);
      try {
        work(exchange);
      } catch (...) {
        thrown[static_cast<std::size_t>(rank)] = std::current_exception();
        group.barrier.arrive_and_drop();
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : thrown)
    if (error) std::rethrow_exception(error);
}

}  // namespace spoke::test
