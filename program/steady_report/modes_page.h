#pragma once

// Makes modes.html of `spoke modes`, campbell.html of `spoke campbell` and critical.html of `spoke
// critical`; docs/modes.md documents them.

#include <string>

#include "engine/campbell.h"
#include "engine/critical.h"

namespace spoke::steady_report {

/// Shows the modes as a table, and the chosen one as a moving picture; `scenario`: that of the
/// result.
std::string make_html(const ModesResult& result, const Scenario& scenario,
                      const std::string& title);
/// Shows the diagram, damping over speed if there is damping, the chosen mode as a moving picture,
/// and the tables; `harmonics`: excitation lines.
std::string make_html(const CampbellResult& result, int harmonics, const Scenario& scenario,
                      const std::string& title);
/// Shows what was found, frequencies and growth over what was varied, and the critical mode as a
/// moving picture. `options`: those of the result.
std::string make_html(const CriticalResult& result, const CriticalOptions& options,
                      const Scenario& scenario, const std::string& title);

}  // namespace spoke::steady_report
