#pragma once

// The processes that mpirun has started together.

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/exchange.h"

namespace spoke::ranks {

/// This process among those of `mpirun -n P spoke ...`; the only one otherwise, and in builds
/// without MPI. At most one object in a process.
class Launch {
 public:
  Launch();
  /// Leaves the others in order; while an exception leaves, only if they do not wait for this
  /// process any more: otherwise MPI ends all processes with this one.
  ~Launch();
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  int count() const { return count_; }
  bool is_first() const { return rank_ == 0; }
  /// From here on no other process waits for this one.
  void release() { is_released_ = true; }

  // By all processes at once; alone, the number itself.
  /// The number of the first one.
  std::uint64_t broadcast(std::uint64_t number) const;
  /// The numbers of all.
  std::vector<std::uint64_t> gather(std::uint64_t number) const;

  /// What a message of 4 kB takes from the first process to the second, or back [s]; 0 if this one
  /// is alone. By all processes at once.
  double measure_latency() const;

  /// How the processes simulate one model together; none if this one is alone.
  std::unique_ptr<Exchange> make_exchange() const;

 private:
  int rank_ = 0, count_ = 1;
  bool is_released_ = false;
};

}  // namespace spoke::ranks
