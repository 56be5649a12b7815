#pragma once

// Writes critical.csv and critical.json of `spoke critical`; docs/modes.md documents them.

#include <string>

#include "engine/critical.h"
#include "program/report/page.h"

namespace spoke::steady_report {

/// What is varied, for people.
struct VariedQuantity {
  std::string name;    ///< "speed", "factor of the load tip"
  std::string unit;    ///< "rad/s"; empty for a factor
  std::string column;  ///< of the table: "speed_rad_per_s", "load_factor"

  bool is_speed() const { return !unit.empty(); }
  /// Returns "12.5 rad/s".
  std::string with_unit(double value, int digits) const;
};
VariedQuantity name_varied(const CriticalOptions& options);

/// Says what was found, in a sentence without its full stop.
std::string describe_critical(const CriticalResult& result, const CriticalOptions& options);
/// Makes a row per branch, with its frequency and growth at the first value and at the last.
report::Table make_branch_table(const CriticalResult& result, const CriticalOptions& options);
/// Returns critical.csv, a row per value and branch.
std::string make_csv(const CriticalResult& result, const CriticalOptions& options);
/// Returns critical.json: everything, with the shape of the critical mode alone.
std::string make_json(const CriticalResult& result, const CriticalOptions& options);

}  // namespace spoke::steady_report
