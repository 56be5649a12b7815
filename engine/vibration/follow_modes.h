#pragma once

// Follows modes over a row of states: speeds, or factors of a load.

#include <vector>

#include "engine/campbell.h"

namespace spoke::vibration {

/// Whether a mode whose frequency passes zero goes on. Its root is then the conjugate of the one
/// before, and so is its shape: a whirl, seen from the turning frame, turns the other way.
enum class ThroughZero { no, yes };

/// Joins the modes of each state and the next, those with the largest modal assurance criterion
/// first. States without modes are passed over. Branches begin with the first `count` modes of each
/// subsystem, or of the whole model, at the first state; empty where fewer than two have modes.
std::vector<CampbellBranch> follow_modes(const std::vector<ModesResult>& states, int count,
                                         ThroughZero through_zero = ThroughZero::no);

}  // namespace spoke::vibration
