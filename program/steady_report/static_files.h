#pragma once

// Writes static.json, section_forces.csv and static.html of `spoke static`; docs/modes.md documents
// them.

#include <string>
#include <string_view>

#include "engine/equilibrium.h"
#include "program/report/page.h"

namespace spoke::steady_report {

/// Returns "decay", "persist" or "grow".
std::string_view word_of(SmallMotions motions);
/// Makes a row for each blade's tip motion, joints and closed loops.
report::Table make_tip_table(const EquilibriumResult& result);
report::Table make_joint_table(const EquilibriumResult& result);
report::Table make_loop_table(const EquilibriumResult& result);
/// Makes a row for each of several rotors: its speed, place and wrench.
report::Table make_rotor_table(const EquilibriumResult& result);
/// Returns speed, hub wrench and the course of the search.
std::vector<report::Fact> make_facts(const EquilibriumResult& result);

/// Returns static.json, with everything.
std::string make_json(const EquilibriumResult& result);
/// Returns section_forces.csv: a row per blade and body with the wrench where the body begins.
std::string make_section_csv(const EquilibriumResult& result);
/// Returns static.html: a picture, deflections over the radius, tables and facts; `scenario`: that
/// of the result.
std::string make_html(const EquilibriumResult& result, const Scenario& scenario,
                      const std::string& title);

}  // namespace spoke::steady_report
