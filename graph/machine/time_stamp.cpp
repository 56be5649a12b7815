// Finds out whether the processor's counter is steady, and measures its rate and cost.

#include "graph/machine/time_stamp.h"

#include <algorithm>
#include <array>
#include <chrono>

#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#endif

namespace spoke::graph {
namespace {

using Clock = std::chrono::steady_clock;

bool find_steady_counter() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  // "Invariant TSC": constant rate in all states of frequency and sleep.
  unsigned a = 0, b = 0, c = 0, d = 0;
  return __get_cpuid(0x80000007U, &a, &b, &c, &d) != 0 && (d & (1U << 8U)) != 0;
#else
  return false;
#endif
}

}  // namespace

namespace detail {

const bool has_steady_counter = find_steady_counter();

std::uint64_t steady_clock_ticks() noexcept {
  return static_cast<std::uint64_t>(Clock::now().time_since_epoch().count());
}

}  // namespace detail

namespace {

/// One instant, by the clock and by the counter.
struct Instant {
  Clock::time_point time = Clock::now();
  std::uint64_t ticks = time_stamp();
};
const Instant program_start;

// Measures the rate since the program's start, which is mostly long enough ago.
double measure_seconds_per_tick() {
  Instant now;
  while (now.time - program_start.time < std::chrono::milliseconds(2)) now = {};
  return std::chrono::duration<double>(now.time - program_start.time).count() /
         static_cast<double>(now.ticks - program_start.ticks);
}

double measure_cost_in_ticks() {
  std::array<std::uint64_t, 101> costs;
  for (std::uint64_t& cost : costs) {
    const std::uint64_t first = time_stamp();
    cost = time_stamp() - first;
  }
  std::nth_element(costs.begin(), costs.begin() + costs.size() / 2, costs.end());
  return static_cast<double>(costs[costs.size() / 2]);
}

TimeStampScale measure_scale() {
  const double seconds = measure_seconds_per_tick();
  return {seconds, seconds * measure_cost_in_ticks()};
}

}  // namespace

const TimeStampScale& time_stamp_scale() {
  static const TimeStampScale scale = measure_scale();
  return scale;
}

}  // namespace spoke::graph
