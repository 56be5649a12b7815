#pragma once

// The processes of a study that mpirun has started together.

#include <cstdint>

#include "engine/study/runner.h"

namespace spoke::study {

/// This process among those of `mpirun -n P spoke study`; the only one otherwise, and in builds
/// without MPI. The first one has the journal and writes the files; the others get runs from it, on
/// each of their threads the next one as soon as that is free. At most one object in a process.
class Ranks {
 public:
  Ranks();
  /// Leaves the others in order; while an exception leaves, only if they have been told to end:
  /// otherwise MPI ends all processes with this one.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int count() const { return count_; }
  bool is_first() const { return rank_ == 0; }

  /// Of the first: tells the others which study there is to do, by its fingerprint(); 0: none.
  void announce(std::uint64_t study);
  /// Of the others: waits for that.
  std::uint64_t hear();

  /// Of the first: makes runs on so many threads, and hands out runs to the other ranks until all
  /// have ended. Throws like make_runs().
  void make_runs_together(const Study& study, const Sampling& sampling, int threads,
                          JournalExchange& exchange);
  /// Of the others: makes runs that the first hands out.
  void make_runs_for_first(const Study& study, const Sampling& sampling, int threads);

 private:
  int rank_ = 0, count_ = 1;
  bool is_released_ = false;  ///< the others have been told to end
};

/// Whether this build knows MPI.
bool has_mpi();

}  // namespace spoke::study
