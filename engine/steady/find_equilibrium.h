#pragma once

// Where a model stands still in the frame that turns with its hub.

#include <string>
#include <vector>

#include "engine/steady/steady_model.h"

namespace spoke::steady {

/// A model's equilibrium.
struct Equilibrium {
  std::vector<Eigen::VectorXd> q;  ///< by tree; spherical joints have been settled
  std::vector<std::size_t> alike;  ///< by tree: the first one that is like it
  HubVector wrench;                ///< that support and drive exert on the hub, hub frame [N, N m]
  double force_scale = 0.0;        ///< sum of what the trees exert, to judge remainders by [N, N m]
  int iterations = 0;              ///< of Newton's method, all trees and load steps together
  int load_steps = 0;              ///< 1: all loads at once
  double last_change = 0.0;        ///< of a coordinate by its scale, in the last iteration
  /// A coordinate that nothing holds: forces balance wherever it is. Empty if there is none.
  std::string loose;
};

/// Finds it by Newton's method with a line search; where that fails, loads, gravity and the square
/// of the speed grow in steps. Throws DivergenceError, naming body and coordinate. Leaves the model
/// at its equilibrium.
Equilibrium find_equilibrium(SteadyModel& model);

/// Throws InputError if it has a loose coordinate.
void require_held(const Equilibrium& equilibrium);

/// Throws InputError unless what acts on the free components of the hub is in balance: else there
/// is no steady rotation to vibrate about. A torque drive gives what torque is needed.
void require_steady_hub(const SteadyModel& model, const Equilibrium& equilibrium);

/// State of a tree at rest at q.
TreeState make_state(const Eigen::VectorXd& q);

}  // namespace spoke::steady
