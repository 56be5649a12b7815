#pragma once

// The processes of a study that mpirun has started together.

#include <cstdint>

#include "engine/ranks/launch.h"
#include "engine/study/runner.h"

namespace spoke::study {

/// This process among those of `mpirun -n P spoke study`. The first one has the journal and writes
/// the files; the others get runs from it, on each of their threads the next one as soon as that is
/// free.
class Ranks {
 public:
  int count() const { return launch_.count(); }
  bool is_first() const { return launch_.is_first(); }

  /// Of the first: tells the others which study there is to do, by its fingerprint(); 0: none.
  void announce(std::uint64_t study) {
    if (study == 0) launch_.release();
    launch_.broadcast(study);
  }
  /// Of the others: waits for that.
  std::uint64_t hear() { return launch_.broadcast(0); }

  /// Of the first: makes runs on so many threads, and hands out runs to the other ranks until all
  /// have ended. Throws like make_runs().
  void make_runs_together(const Study& study, const Sampling& sampling, int threads,
                          JournalExchange& exchange);
  /// Of the others: makes runs that the first hands out.
  void make_runs_for_first(const Study& study, const Sampling& sampling, int threads);

 private:
  ranks::Launch launch_;
};

}  // namespace spoke::study
