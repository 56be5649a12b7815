#pragma once

// Parts of modes.json that other files have, too.

#include "engine/modes.h"
#include "models/support/json.h"

namespace spoke::steady_report {

/// Returns name, frequency, damping, eigenvalue and shape of a mode.
Json mode_json(const Mode& mode, const std::vector<std::string>& bodies);
/// Returns by blade its name, and the places of its nodes in equilibrium.
Json nodes_json(const EquilibriumResult& equilibrium);

}  // namespace spoke::steady_report
