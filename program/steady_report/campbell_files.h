#pragma once

// Writes campbell.csv and campbell.json of `spoke campbell`; docs/modes.md documents them.

#include <string>
#include <vector>

#include "engine/campbell.h"
#include "program/report/page.h"

namespace spoke::steady_report {

/// Makes a row per crossing.
report::Table make_crossing_table(const CampbellResult& result);
/// Makes a row per speed at which there is no equilibrium, with the reason.
report::Table make_gap_table(const CampbellResult& result);
/// Makes a row per branch, with its names and frequencies at the first and at the last speed.
report::Table make_branch_table(const CampbellResult& result);
/// Returns a line per branch that ends before the last speed.
std::vector<std::string> describe_losses(const CampbellResult& result);
/// Returns campbell.csv, a row per speed and branch.
std::string make_csv(const CampbellResult& result);
/// Returns campbell.json: everything except shapes.
std::string make_json(const CampbellResult& result);

}  // namespace spoke::steady_report
