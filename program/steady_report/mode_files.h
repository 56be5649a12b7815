#pragma once

// Writes modes.json and modes.csv of `spoke modes`; docs/modes.md documents them.

#include <string>

#include "engine/modes.h"
#include "models/support/json.h"
#include "program/report/page.h"

namespace spoke::steady_report {

/// Converts a frequency from rad/s to Hz.
double hertz(double frequency);
/// Returns a mode's damping ratio; 0 if it is only round-off.
double damping_of(const Mode& mode);

/// Returns a frame as --frame has it, and in words.
std::string name_of(ModeFrame frame);
std::string describe(ModeFrame frame);

/// Makes a row per mode.
report::Table make_mode_table(const ModesResult& result);
/// Returns the speed of the hub, or of each of several rotors: "main 36, tail 180 rad/s".
std::string describe_speeds(const EquilibriumResult& result);
/// Returns name and speed of each of several rotors.
Json speeds_json(const EquilibriumResult& result);
/// Returns a remark about modes that grow; empty if none does.
std::string describe_growth(const ModesResult& result);
/// Returns modes.json: everything except the matrices, shapes included.
std::string make_json(const ModesResult& result);
/// Returns modes.csv, a row per mode.
std::string make_csv(const ModesResult& result);

}  // namespace spoke::steady_report
