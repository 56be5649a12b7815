#pragma once

// The equilibrium of a model: where it stands still in the frame that turns with its hub.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// A model's equilibrium.
struct Equilibrium {
  std::vector<Eigen::VectorXd> q;              ///< by subsystem; spherical joints have been settled
  std::vector<Eigen::VectorXd> multipliers{};  ///< by subsystem: forces of the rows of its loops
  /// By subsystem: the rigid rows that do not depend on others.
  std::vector<std::vector<Eigen::Index>> rows{};
  std::vector<std::size_t> alike;  ///< by subsystem: the first one that is like it
  HubVector wrench;                ///< of support and drive on the hub, hub frame [N, N m]
  /// Of rotors on a support: the wrench of each hub, that of the first again.
  std::vector<HubVector> wrenches{};
  double force_scale = 0.0;  ///< sum of the forces of subsystems, to judge remainders by [N, N m]
  int iterations = 0;        ///< of Newton's method, for all subsystems and load steps
  int load_steps = 0;        ///< 1: all loads were applied at once
  double last_change = 0.0;  ///< change of a coordinate by its scale in the last iteration
  /// A coordinate that nothing holds: forces balance wherever it is. Empty if there is none.
  std::string loose;
};

/// Finds the equilibrium by Newton's method with a line search; where that fails, loads, gravity
/// and the square of the speed grow in steps. Throws DivergenceError, naming body and coordinate.
/// Leaves the model at its equilibrium.
Equilibrium find_equilibrium(SteadyModel& model);

struct Tangent;
/// By subsystem: the derivative by which its equilibrium was found last, or none.
using Tangents = std::vector<std::shared_ptr<const Tangent>>;

/// Goes on from the equilibrium `at` of `before`, another model of the same bodies, which stands
/// near: all loads at once. Returns none if Newton's method finds no equilibrium from there; the
/// model is then at no state in particular. kept: what trials after one another, between which next
/// to nothing changes, may share; empty at first.
std::optional<Equilibrium> continue_equilibrium(const Equilibrium& at, const SteadyModel& before,
                                                SteadyModel& model, Tangents* kept = nullptr);

/// Throws InputError if the equilibrium has a loose coordinate.
void require_held(const Equilibrium& equilibrium);

/// Throws InputError unless the forces on the free components of the hub are in balance: otherwise
/// there is no steady rotation to vibrate about. A torque drive
/// gives whatever torque is needed.
void require_steady_hub(const SteadyModel& model, const Equilibrium& equilibrium);

/// Returns the state of a subsystem at rest at q.
SubsystemState make_state(const Eigen::VectorXd& q);
/// Returns the state of a subsystem at rest, where its loops have these forces.
SubsystemState make_state(const Eigen::VectorXd& q, const Eigen::VectorXd& multipliers);
/// Returns the equilibrium of a subsystem.
SubsystemState make_state(const Equilibrium& equilibrium, std::size_t subsystem);

}  // namespace spoke::steady
