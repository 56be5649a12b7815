#pragma once

// The processes that mpirun has started together.

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/exchange.h"

namespace spoke::ranks {

/// Whether a launcher such as mpirun has started this process beside others.
bool is_launched();

/// This process among those of `mpirun -n P spoke ...`; the only one otherwise, and in builds
/// without MPI. There is at most one object in a process.
class Launch {
 public:
  Launch();
  /// Ends MPI together with the others. During an exception it does so only if they do not wait for
  /// this process any more; otherwise MPI ends all processes with this one.
  ~Launch();
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  int count() const { return count_; }
  bool is_first() const { return rank_ == 0; }
  /// Declares that no other process waits for this one from here on.
  void release() { is_released_ = true; }

  // Returns the number of the first process; called by all at once.
  std::uint64_t broadcast(std::uint64_t number) const;
  /// Returns the numbers of all processes; called by all at once.
  std::vector<std::uint64_t> gather(std::uint64_t number) const;

  /// Makes the exchange by which the processes simulate one model together; null if this one is
  /// alone.
  std::unique_ptr<Exchange> make_exchange() const;

 private:
  int rank_ = 0, count_ = 1;
  bool is_released_ = false;
};

}  // namespace spoke::ranks
