#pragma once

// Exchange of data between processes that simulate one model together.

#include <cstddef>
#include <span>

#include "spoke/export.h"

namespace spoke {

/// A group of processes ("ranks"), each with its number, like those that mpirun starts. The engine
/// knows no network: a program that spreads a simulation over processes derives a class from this
/// one, see SimulationOptions::exchange.
class SPOKE_EXPORT Exchange {
 public:
  virtual ~Exchange() = default;
  virtual int rank() const = 0;   ///< of this process, from 0
  virtual int count() const = 0;  ///< number of processes
  /// Completes `all`. Its bytes first[r] to first[r + 1] are those of rank r, which sets them
  /// beforehand. Returns when those of all ranks are there, with the bits that they set. `first`
  /// has count() + 1 places and is the same on all ranks. All ranks make the same calls in the same
  /// order, one at a time, from any thread. Must not throw: an error that cannot be repaired must
  /// end the processes.
  virtual void share(std::span<std::byte> all, std::span<const std::size_t> first) noexcept = 0;
};

}  // namespace spoke
