#pragma once

// What air does to a rotor in equilibrium, for the files and the page of `spoke static`.

#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "models/support/json.h"
#include "program/report/page.h"

namespace spoke::steady_report {

/// Makes the facts of wind, thrust, torque and power. Precondition: air acts.
std::vector<report::Fact> make_air_facts(const EquilibriumResult& result);
/// Whether air acts on any blade.
bool has_air(const EquilibriumResult& result);
/// Returns "air" of static.json, of a rotor that turns at a speed [rad/s].
Json air_json(const RotorAir& air, double speed);
/// Returns "air" of a blade in static.json, by station.
Json section_air_json(const BladeEquilibrium& blade);
/// Returns section_air.csv, a row per blade and station.
std::string make_air_csv(const EquilibriumResult& result);
/// Adds span-wise plots of the flow and the loads of one blade, the first on which air acts.
void add_air_charts(const EquilibriumResult& result, report::Page& page);

}  // namespace spoke::steady_report
