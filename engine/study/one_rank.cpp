// Of builds without MPI: this process is alone.

#include "engine/study/ranks.h"

namespace spoke::study {

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

void Ranks::announce(std::uint64_t) { is_released_ = true; }
std::uint64_t Ranks::hear() { return 0; }

void Ranks::make_runs_together(const Study& study, const Sampling& sampling, int threads,
                               JournalExchange& exchange) {
  make_runs(study, sampling, threads, exchange);
}

void Ranks::make_runs_for_first(const Study&, const Sampling&, int) {}

bool has_mpi() { return false; }

}  // namespace spoke::study
