#pragma once

// Charts of deflections in equilibrium, for the page of `spoke static`.

#include "engine/equilibrium.h"
#include "program/report/page.h"

namespace spoke::steady_report {

/// Adds deflections of blades and other subsystems over the distance from the hub, along the axis
/// of rotation and across it, and those of a support over the distance from its base.
void add_deflection_charts(const EquilibriumResult& result, report::Page& page);

}  // namespace spoke::steady_report
