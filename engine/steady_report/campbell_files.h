#pragma once

// campbell.csv and campbell.json of `spoke campbell`; docs/modes.md documents them.

#include <string>

#include "engine/campbell.h"
#include "engine/report/page.h"

namespace spoke::steady_report {

/// A row per crossing.
report::Table make_crossing_table(const CampbellResult& result);
/// A row per speed at which there is no equilibrium, and why.
report::Table make_gap_table(const CampbellResult& result);
/// Branches with their frequencies at the first and at the last speed.
report::Table make_branch_table(const CampbellResult& result);
/// A row per speed and branch.
std::string make_csv(const CampbellResult& result);
/// Everything but shapes.
std::string make_json(const CampbellResult& result);

}  // namespace spoke::steady_report
