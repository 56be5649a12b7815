#pragma once

// Statistics of a run's rows on report.html.

#include <vector>

#include "engine/run_statistics.h"
#include "program/report/page.h"

namespace spoke::run_report {

/// Returns means of power and thrust of the air as tiles; none where no statistics are collected.
std::vector<report::Tile> make_mean_tiles(const Simulation& simulation, const RunStatistics& rows);

/// Returns the statistics of summary.json, a row for each sensor that has some.
report::Table make_statistics_table(const Simulation& simulation, const RunStatistics& rows);

}  // namespace spoke::run_report
