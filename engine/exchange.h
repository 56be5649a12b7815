#pragma once

// How processes that simulate one model together tell one another what they found.

#include <cstddef>
#include <span>

#include "spoke/export.h"

namespace spoke {

/// A group of processes ("ranks") of which each has its number, as those that mpirun starts. The
/// engine knows no network: a program that spreads a simulation over processes derives from this,
/// see SimulationOptions::exchange.
class SPOKE_EXPORT Exchange {
 public:
  virtual ~Exchange() = default;
  virtual int rank() const = 0;   ///< of this process, from 0
  virtual int count() const = 0;  ///< of processes
  /// Completes `all`, of which bytes first[r] to first[r + 1] are of rank r, and are set by that
  /// rank beforehand: returns when those of all ranks are there, with the bits that they gave.
  /// `first` has count() + 1 places and is the same on all ranks. All ranks make the same calls in
  /// the same order, one at a time, from any thread. Must not throw: what cannot be repaired ends
  /// the processes.
  virtual void share(std::span<std::byte> all, std::span<const std::size_t> first) noexcept = 0;
};

}  // namespace spoke
