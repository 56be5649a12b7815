#pragma once

// Effects of the loads of a scenario on a model in equilibrium.

#include <vector>

#include "engine/small_motions/steady/find_equilibrium.h"

namespace spoke::steady {

/// The effect of raising an input by one: a load by its factor, a motor by its effort. A vector is
/// empty where the input has no effect.
struct LoadEffect {
  LinearSignal input;
  Eigen::VectorXd force;      ///< on the coordinates of its subsystem
  Eigen::VectorXd hub_force;  ///< on the hub that carries it, all components
  Eigen::VectorXd outputs;    ///< of its subsystem
};

/// The effects on the subsystems, and on each hub alone.
struct LoadEffects {
  std::vector<std::vector<LoadEffect>> subsystems;
  std::vector<std::vector<LoadEffect>> hubs;
};

/// What raising an input by one does to everything: `subsystems` has an entry for each, whose
/// `input` is empty.
struct InputEffect {
  LinearSignal input;  ///< without the name of what it acts on
  std::vector<LoadEffect> subsystems;
  std::vector<Eigen::VectorXd> hubs;  ///< on each hub alone, all components
};

/// Calculates the effects from models in which one input each is raised by one and all else is as
/// in `model` at `equilibrium`: forces and accelerations are linear in loads. Every load counts
/// separately for each subsystem.
LoadEffects calc_load_effects(const Scenario& scenario, const Equilibrium& equilibrium,
                              SteadyModel& model);
/// As calc_load_effects(), for every input; but with all parts of loads of constant direction, as
/// they are at an azimuth of all hubs. Vectors are along the axes that the hub has there.
std::vector<InputEffect> calc_effects_at(double azimuth, const Scenario& scenario,
                                         const Equilibrium& equilibrium, SteadyModel& model);

}  // namespace spoke::steady
