#pragma once

// The page of a study, study.html.

#include <string>

#include "engine/study/analysis.h"

namespace spoke::study_report {

/// A page without network: the runs as parallel coordinates and points, what each parameter does to
/// each response, Sobol indices, and commands that make the runs at the ends again. Of many runs
/// some are drawn, evenly chosen.
std::string make_html(const study::Study& study, const study::Sampling& sampling,
                      const study::ForEachRun& for_each, const study::Analysis& analysis);

}  // namespace spoke::study_report
