#pragma once

// Makes the analysis of a study.

#include "engine/study/analysis.h"

namespace spoke::study {

/// Goes through all runs, some times.
Analysis analyse(const Study& study, const Sampling& sampling, const ForEachRun& for_each);

}  // namespace spoke::study
