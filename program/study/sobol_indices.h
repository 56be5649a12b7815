#pragma once

// Sobol indices from the runs of a design of the kind saltelli.

#include "program/study/analysis.h"

namespace spoke::study {

/// Fills in the indices of the responses, from points whose runs all have the response. First
/// order: A. Saltelli et al., "Variance based sensitivity analysis of model output", Comput. Phys.
/// Commun. 181 (2010) 259-270, their estimator (b); total: Jansen's, their (f). `sampled`: the
/// parameters in the order of the design.
void find_sobol_indices(const std::vector<std::size_t>& sampled, const ForEachRun& for_each,
                        Analysis& analysis);

}  // namespace spoke::study
