#pragma once

// The processes of a study that mpirun has started together.

#include <cstdint>

#include "program/ranks/launch.h"
#include "program/study/runner.h"

namespace spoke::study {

/// This process among those of `mpirun -n P spoke study`. The first one has the journal and writes
/// the files; each thread of the others gets a run from it as soon as the thread is free.
class Ranks {
 public:
  int count() const { return launch_.count(); }
  bool is_first() const { return launch_.is_first(); }

  /// Tells the other ranks, from the first, the fingerprint() of the study to be made; 0: none.
  void announce(std::uint64_t study) {
    if (study == 0) launch_.release();
    launch_.broadcast(study);
  }
  /// Waits for announce(), on the other ranks.
  std::uint64_t hear() { return launch_.broadcast(0); }

  /// Makes runs on so many threads, for the first rank, and hands out runs to the other ranks until
  /// all have ended. Throws like make_runs().
  void make_runs_together(const Study& study, const Sampling& sampling, int threads,
                          JournalExchange& exchange);
  /// Makes runs that the first rank hands out, for the other ranks.
  void make_runs_for_first(const Study& study, const Sampling& sampling, int threads);

 private:
  ranks::Launch launch_;
};

}  // namespace spoke::study
