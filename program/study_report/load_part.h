#pragma once

// The part of a study's page about loads.

#include "program/report/page.h"
#include "program/study/load_analysis.h"

namespace spoke::study_report {

/// Adds tables of extremes, of lifetime loads and of statistics by wind speed, and charts over it.
void add_loads(const study::Study& study, const study::LoadAnalysis& loads, report::Page& page);

}  // namespace spoke::study_report
