#pragma once

// Where a model stands in steady rotation, or at rest.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/warnings.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

class Simulation;

/// About which steady motion.
struct SteadyState {
  /// Of the hub about its axis [rad/s]; none: the speed that the scenario's drive leads to.
  std::optional<double> speed = std::nullopt;
};

/// A coordinate of a joint in equilibrium.
struct JointPosition {
  std::string name;    ///< the joint's, with a number if it has several coordinates
  double value = 0.0;  ///< [rad, m]
  bool turns = true;   ///< an angle [rad], else a way [m]
};

/// What the outer part of a blade exerts on the inner one where a body begins, in the axes of the
/// section there: as the sensor `section_force` has it, tension being positive. Of a rigid body in
/// its own axes.
struct SectionLoad {
  std::string body;                       ///< that begins there
  double station = 0.0;                   ///< undeformed distance from the root [m]
  Eigen::Vector3d force{0.0, 0.0, 0.0};   ///< [N]
  Eigen::Vector3d moment{0.0, 0.0, 0.0};  ///< [N m]
};

/// A blade, or another subsystem, in equilibrium. Vectors are in the hub's frame.
struct BladeEquilibrium {
  std::string name;                                 ///< "blade 1", or the subsystem's
  Eigen::Vector3d tip_displacement{0.0, 0.0, 0.0};  ///< from its undeformed place [m]
  Eigen::Vector3d tip_rotation{0.0, 0.0, 0.0};      ///< rotation vector [rad]
  std::vector<JointPosition> joints;                ///< that are free
  std::vector<SectionLoad> loads;                   ///< from the root on
  std::vector<Eigen::Vector3d> nodes;               ///< places, from root to tip [m]
  std::vector<Eigen::Vector3d> undeformed;          ///< of the same nodes, joints as they are [m]
  std::vector<Eigen::Matrix3d> undeformed_axes;     ///< there, of their bodies: columns
  std::vector<Eigen::Vector3d> rotations;           ///< of the nodes from there, rotation vectors
  std::vector<int> bodies;                          ///< to which they belong, from 0
  /// By body, its largest deflection across its axis by its length; of rigid ones 0.
  std::vector<double> bending;
};

/// A model in equilibrium.
struct EquilibriumResult {
  double speed = 0.0;                    ///< of the hub [rad/s]
  std::vector<BladeEquilibrium> blades;  ///< then other subsystems
  /// What support and drive exert on the hub at its origin, hub frame [N], [N m].
  Eigen::Vector3d hub_force{0.0, 0.0, 0.0};
  Eigen::Vector3d hub_moment{0.0, 0.0, 0.0};  ///< likewise
  int iterations = 0;                         ///< of Newton's method, over all blades
  int load_steps = 1;                         ///< in which loads were applied
  double last_change = 0.0;  ///< of a coordinate in the last iteration [rad, or by length]
  /// What makes it doubtful: a body that bends beyond `limits.deflection`.
  std::vector<Warning> warnings{};
};

/// Finds the equilibrium of a scenario's model in steady rotation or at rest, by Newton's method
/// with a line search and, where needed, load steps. Loads, motors and prescribed joints have the
/// values that their curves end with, pitch that follows the azimuth its mean. Where the hub turns,
/// gravity and loads of constant direction count with their part along the axis: the rest turns
/// against the model. Throws InputError if the scenario is none, if the speed is not finite, if the
/// drive is a torque and no speed is given, or if nothing holds the hub or a joint;
/// DivergenceError, naming body and coordinate, if no equilibrium is found.
SPOKE_EXPORT EquilibriumResult solve_equilibrium(const Scenario& scenario,
                                                 const SteadyState& state = {});
/// The same of what is simulated, with the drive in force; loads of the user's own do not count.
SPOKE_EXPORT EquilibriumResult solve_equilibrium(const Simulation& simulation,
                                                 const SteadyState& state = {});

}  // namespace spoke
