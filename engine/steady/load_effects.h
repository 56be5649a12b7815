#pragma once

// What the loads of a scenario do to a model in equilibrium.

#include <vector>

#include "engine/steady/find_equilibrium.h"

namespace spoke::steady {

/// What one more of an input does: a load by its factor, a motor by its effort. Empty vectors: to
/// that nothing.
struct LoadEffect {
  LinearSignal input;
  Eigen::VectorXd force;      ///< on the coordinates of its tree
  Eigen::VectorXd hub_force;  ///< on the hub, all components
  Eigen::VectorXd outputs;    ///< of its tree
};

/// The effects on the trees, and on the hub alone.
struct LoadEffects {
  std::vector<std::vector<LoadEffect>> trees;
  std::vector<LoadEffect> hub;
};

/// Finds them by models with one more of each, in which all else is as in `model` at `equilibrium`:
/// forces and accelerations are linear in loads. Every load counts by tree.
LoadEffects calc_load_effects(const Scenario& scenario, const Equilibrium& equilibrium,
                              SteadyModel& model);

}  // namespace spoke::steady
