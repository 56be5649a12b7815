#pragma once

// What each parameter does to each response by itself.

#include "engine/study/analysis.h"

namespace spoke::study {

/// Fills in the effects of responses whose summaries are known, of any design but a table.
void find_main_effects(const Study& study, const Sampling& sampling, const ForEachRun& for_each,
                       Analysis& analysis);

}  // namespace spoke::study
