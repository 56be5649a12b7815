#pragma once

// The cheapest clock that there is, for single nodes.

#include <cstdint>

namespace spoke::graph {

namespace detail {
/// Whether the processor has a time stamp counter that is constant and never stops.
extern const bool has_steady_counter;
std::uint64_t steady_clock_ticks() noexcept;
}  // namespace detail

/// Reads the fastest clock that counts at a constant rate and never stops: the processor's time
/// stamp counter where it has one, otherwise std::chrono::steady_clock. In ticks.
inline std::uint64_t time_stamp() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  if (detail::has_steady_counter) return __builtin_ia32_rdtsc();
#endif
  return detail::steady_clock_ticks();
}

/// Reads the clock after all earlier reads of the thread are complete: if they show that another
/// thread did something after a stamp of its own, this stamp is no earlier. Without this,
/// processors read the counter ahead of reads that they wait for.
inline std::uint64_t time_stamp_after_reads() noexcept {
#ifdef __SSE2__
  __builtin_ia32_lfence();
#endif
  return time_stamp();
}

/// The unit and cost of time stamps on this machine.
struct TimeStampScale {
  double seconds_per_tick = 0.0;
  double cost = 0.0;  ///< time from one stamp to the next with nothing in between [s]
};

/// Returns the scale, measured once per process, against std::chrono::steady_clock, in about 2 ms.
const TimeStampScale& time_stamp_scale();

/// Returns the time since time_stamp() gave `begin` [s].
inline double seconds_since(std::uint64_t begin) {
  return static_cast<double>(time_stamp() - begin) * time_stamp_scale().seconds_per_tick;
}

}  // namespace spoke::graph
