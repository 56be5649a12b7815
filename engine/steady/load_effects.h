#pragma once

// Effects of the loads of a scenario on a model in equilibrium.

#include <vector>

#include "engine/steady/find_equilibrium.h"

namespace spoke::steady {

/// The effect of raising an input by one: a load by its factor, a motor by its effort. A vector is
/// empty where the input has no effect.
struct LoadEffect {
  LinearSignal input;
  Eigen::VectorXd force;      ///< on the coordinates of its subsystem
  Eigen::VectorXd hub_force;  ///< on the hub, all components
  Eigen::VectorXd outputs;    ///< of its subsystem
};

/// The effects on the subsystems, and on the hub alone.
struct LoadEffects {
  std::vector<std::vector<LoadEffect>> subsystems;
  std::vector<LoadEffect> hub;
};

/// Calculates the effects from models in which one input each is raised by one and all else is as
/// in `model` at `equilibrium`: forces and accelerations are linear in loads. Every load counts
/// separately for each subsystem.
LoadEffects calc_load_effects(const Scenario& scenario, const Equilibrium& equilibrium,
                              SteadyModel& model);

}  // namespace spoke::steady
