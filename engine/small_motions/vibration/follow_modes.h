#pragma once

// Follows modes over a row of states: speeds, or factors of a load.

#include <functional>
#include <optional>
#include <vector>

#include "engine/campbell.h"
#include "engine/small_motions/vibration/match_modes.h"

namespace spoke::vibration {

/// What lies between the states of a row.
struct BetweenStates {
  std::vector<double> values;  ///< by state, ascending
  /// Returns the modes at a value between two of them; none if there is no equilibrium.
  std::function<std::optional<ModesResult>(double)> solve;
};

/// Joins the modes of each state and the next, see match_modes(). States without modes are passed
/// over. Branches begin with the first `count` modes of each subsystem, or of the whole model, at
/// the first state; empty where fewer than two have modes. With `between`, modes are sought between
/// two states where shapes are not alike, or where frequencies change their order, until it is seen
/// how modes go on: those that come close to each other, and part again, do not cross.
std::vector<CampbellBranch> follow_modes(const std::vector<ModesResult>& states, int count,
                                         ThroughZero through_zero = ThroughZero::no,
                                         const BetweenStates* between = nullptr);

}  // namespace spoke::vibration
