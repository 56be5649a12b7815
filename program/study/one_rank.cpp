// Stands for MPI in builds without it: this process is alone.

#include "program/study/ranks.h"

namespace spoke::study {

void Ranks::make_runs_together(const Study& study, const Sampling& sampling, int threads,
                               JournalExchange& exchange) {
  make_runs(study, sampling, threads, exchange);
}

void Ranks::make_runs_for_first(const Study&, const Sampling&, int) {}

}  // namespace spoke::study
