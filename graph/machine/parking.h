#pragma once

// Lets a thread sleep until a number changes.

#include <atomic>
#include <cstdint>

namespace spoke::graph {

/// Sleeps until woken if the value is still `seen`; may return without reason. This is unlike
/// std::atomic::wait, which libstdc++ begins by yielding the processor a few times: where other
/// programs compute, each of these costs a time slice of theirs, milliseconds.
void park(const std::atomic<std::uint32_t>& value, std::uint32_t seen);

/// Wakes all who are parked at the value, by one call of the system.
void unpark_all(std::atomic<std::uint32_t>& value);

}  // namespace spoke::graph
