#pragma once

// Makes modes.html of `spoke modes` and campbell.html of `spoke campbell`; docs/modes.md documents
// them.

#include <string>

#include "engine/campbell.h"

namespace spoke::steady_report {

/// Shows the modes as a table, and the chosen one as a moving picture; `scenario`: that of the
/// result.
std::string make_html(const ModesResult& result, const Scenario& scenario,
                      const std::string& title);
/// Shows the diagram, damping over speed if there is damping, the chosen mode as a moving picture,
/// and the tables; `harmonics`: excitation lines.
std::string make_html(const CampbellResult& result, int harmonics, const Scenario& scenario,
                      const std::string& title);

}  // namespace spoke::steady_report
