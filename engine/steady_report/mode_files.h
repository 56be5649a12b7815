#pragma once

// modes.json and modes.csv of `spoke modes`; docs/modes.md documents them.

#include <string>

#include "engine/modes.h"
#include "engine/report/page.h"

namespace spoke::steady_report {

/// A frequency in rad/s in Hz.
double hertz(double frequency);
/// A mode's damping ratio; what is nothing but round-off is 0.
double damping_of(const Mode& mode);

/// A row per mode.
report::Table make_mode_table(const ModesResult& result);
/// What is to be said of modes that grow; empty if none does.
std::string describe_growth(const ModesResult& result);
/// Everything but the matrices, shapes included.
std::string make_json(const ModesResult& result);
/// A row per mode.
std::string make_csv(const ModesResult& result);

}  // namespace spoke::steady_report
