#pragma once

// The page of a study, study.html.

#include <string>

#include "program/study/analysis.h"

namespace spoke::study_report {

/// Returns a page that needs no network: the runs as parallel coordinates and points, the effect of
/// each parameter on each response, Sobol indices, and commands that repeat the extreme runs. If
/// there are many runs, evenly chosen ones are drawn.
std::string make_html(const study::Study& study, const study::Sampling& sampling,
                      const study::ForEachRun& for_each, const study::Analysis& analysis);

}  // namespace spoke::study_report
