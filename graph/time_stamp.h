#pragma once

#include <cstdint>

namespace spoke::graph {

/// Reads the fastest clock that counts at a constant rate and never stops: the processor's time
/// stamp counter where it does, otherwise std::chrono::steady_clock. In ticks.
std::uint64_t time_stamp() noexcept;

/// What time stamps mean on this machine.
struct TimeStampScale {
  double seconds_per_tick = 0.0;
  double cost = 0.0;  ///< [s] from one stamp to the next with nothing in between
};

/// Measured once per process, against std::chrono::steady_clock, in about 2 ms.
const TimeStampScale& time_stamp_scale();

}  // namespace spoke::graph
