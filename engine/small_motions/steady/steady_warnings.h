#pragma once

// Warnings that make an equilibrium doubtful.

#include "engine/equilibrium.h"
#include "models/scenario.h"

namespace spoke::steady {

/// The body that bends most.
struct LargestBending {
  std::size_t subsystem = 0, body = 0;
  double ratio = 0.0;  ///< deflection across the body's axis by its length; 0 if all are rigid
};
LargestBending find_largest_bending(const EquilibriumResult& result);

/// Returns the name of the body: "blade 1 / body 2".
std::string name_body(const EquilibriumResult& result, const LargestBending& bending);

/// Warns, as a run does, if a body bends beyond the scenario's limits.deflection, up to which its
/// linear elasticity holds.
void add_warnings(const Scenario& scenario, EquilibriumResult& result);

}  // namespace spoke::steady
