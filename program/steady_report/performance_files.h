#pragma once

// Writes performance.csv, performance.json and the page of `spoke performance`;
// docs/aerodynamics.md documents them.

#include <string>

#include "engine/performance.h"
#include "models/scenario.h"
#include "program/report/page.h"

namespace spoke::steady_report {

/// Makes a row per operating point.
report::Table make_performance_table(const PerformanceResult& result);
/// Returns performance.csv, a row per operating point.
std::string make_csv(const PerformanceResult& result);
/// Returns a map as tables of power, thrust and torque coefficients in the form that the controller
/// ROSCO reads, Cp_Ct_Cq.txt; empty if there is no map, or a point of it has no steady state.
/// `sign`: of an angle of the joints towards feather, 1 or -1.
std::string make_coefficient_tables(const PerformanceResult& result, int sign);
/// Returns performance.json.
std::string make_json(const PerformanceResult& result, const Scenario& scenario);
/// Returns performance.html: curves over wind speed, or over tip-speed ratio for each pitch.
std::string make_html(const PerformanceResult& result, const std::string& title);

}  // namespace spoke::steady_report
