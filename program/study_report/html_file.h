#pragma once

// The page of a study, study.html.

#include <optional>
#include <string>

#include "program/study/analysis.h"
#include "program/study/load_analysis.h"

namespace spoke::study_report {

/// Returns a page that needs no network: the runs as parallel coordinates and points, the effect of
/// each parameter on each response, Sobol indices, and commands that repeat the extreme runs. If
/// there are many runs, evenly chosen ones are drawn. Loads follow, where a study has statistics.
std::string make_html(const study::Study& study, const study::Sampling& sampling,
                      const study::ForEachRun& for_each, const study::Analysis& analysis,
                      const std::optional<study::LoadAnalysis>& loads);

}  // namespace spoke::study_report
