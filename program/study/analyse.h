#pragma once

// Makes the analysis of a study.

#include "program/study/analysis.h"

namespace spoke::study {

/// Analyses a study; visits all runs several times.
Analysis analyse(const Study& study, const Sampling& sampling, const ForEachRun& for_each);

}  // namespace spoke::study
