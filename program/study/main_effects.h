#pragma once

// The effect of each parameter by itself on each response.

#include "program/study/analysis.h"

namespace spoke::study {

/// Fills in the effects of responses whose summaries are known, for any design except a table.
void find_main_effects(const Study& study, const Sampling& sampling, const ForEachRun& for_each,
                       Analysis& analysis);

}  // namespace spoke::study
