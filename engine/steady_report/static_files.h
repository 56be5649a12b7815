#pragma once

// static.json, section_forces.csv and static.html of `spoke static`; docs/modes.md documents them.

#include <string>

#include "engine/equilibrium.h"
#include "engine/report/page.h"

namespace spoke::steady_report {

/// Tip motion and joints of each blade, a row each.
report::Table make_tip_table(const EquilibriumResult& result);
report::Table make_joint_table(const EquilibriumResult& result);
/// Speed, hub wrench and how the search went.
std::vector<report::Fact> make_facts(const EquilibriumResult& result);

/// Everything.
std::string make_json(const EquilibriumResult& result);
/// A row per blade and body: the wrench where the body begins.
std::string make_section_csv(const EquilibriumResult& result);
/// A picture, deflections over the radius, tables and facts as a page; `scenario`: of the result.
std::string make_html(const EquilibriumResult& result, const Scenario& scenario,
                      const std::string& title);

}  // namespace spoke::steady_report
