#pragma once

// The equilibrium of a model in steady rotation, or at rest.

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/warnings.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

class Simulation;
namespace space {
struct SolidConstants;
}

/// The steady motion of a model.
struct SteadyState {
  /// Speed of the hub about its axis, of several rotors of the first [rad/s]; none: the speed that
  /// the drive of the scenario leads to.
  std::optional<double> speed = std::nullopt;
  /// Of rotors on a support by their names, likewise; what is not there has its drive's.
  std::map<std::string, double> speeds{};
};

/// A coordinate of a joint in equilibrium.
struct JointPosition {
  std::string name;    ///< of the joint, with a number if it has several coordinates
  double value = 0.0;  ///< [rad, m]
  bool turns = true;   ///< true: an angle [rad]; false: a distance [m]
};

/// Load of a section at the start of a body: the force and moment of the outer part of a blade on
/// the inner one, in the axes of the section, tension being positive, as the sensor `section_force`
/// shows it. For a rigid body in its own axes.
struct SectionLoad {
  std::string body;                       ///< that begins at the section
  double station = 0.0;                   ///< undeformed distance from the root [m]
  Eigen::Vector3d force{0.0, 0.0, 0.0};   ///< [N]
  Eigen::Vector3d moment{0.0, 0.0, 0.0};  ///< [N m]
};

/// Force and moment that the closure of a loop exerts on its place `from`, about it, in the hub's
/// frame.
struct LoopLoad {
  std::string name;
  Eigen::Vector3d force{0.0, 0.0, 0.0};          ///< [N]
  Eigen::Vector3d moment{0.0, 0.0, 0.0};         ///< [N m]
  std::optional<double> tension = std::nullopt;  ///< of a loop of kind `distance` [N]
};

/// The deformation of a solid in equilibrium.
struct SolidDeformation {
  int body = 0;  ///< of the blade or subsystem, from 0
  std::shared_ptr<const space::SolidConstants> solid;
  std::vector<double> coordinates;
};

/// What air does to a section of a blade in equilibrium.
struct SectionAir {
  double station = 0.0;               ///< distance from the root [m]
  double attack = 0.0;                ///< angle of attack [rad]
  double relative_speed = 0.0;        ///< of the air against the section, in its plane [m/s]
  double axial_induction = 0.0;       ///< a
  double tangential_induction = 0.0;  ///< a'
  double lift = 0.0, drag = 0.0, moment = 0.0;  ///< coefficients
  double axial_force = 0.0;       ///< along the rotor's axis, by length of the blade [N/m]
  double tangential_force = 0.0;  ///< in the direction of the turn [N/m]
  double pitching_moment = 0.0;   ///< about the section's axis, nose up [N m/m]
};

/// What air does to a rotor in equilibrium, in the frame of its hub.
struct RotorAir {
  double wind = 0.0;    ///< speed along the axis, against the hub [m/s]
  double thrust = 0.0;  ///< along the axis [N]
  double torque = 0.0;  ///< about the axis [N m]
};

/// A blade, or another subsystem, in equilibrium. Vectors are in the frame of its hub.
struct BladeEquilibrium {
  std::string name;                                 ///< "blade 1", or the subsystem's
  int rotor = 0;                                    ///< number of the rotor that it is on, from 0
  Eigen::Vector3d tip_displacement{0.0, 0.0, 0.0};  ///< from its undeformed place [m]
  Eigen::Vector3d tip_rotation{0.0, 0.0, 0.0};      ///< rotation vector [rad]
  std::vector<JointPosition> joints;                ///< coordinates of free joints
  std::vector<SectionLoad> loads;                   ///< of sections, from the root on
  std::vector<LoopLoad> loops;                      ///< of closed loops
  /// Places, from root to tip [m]; of a solid those of its frame, its interfaces, and sets of nodes
  /// that loads act on, then some nodes of its mesh, at most 200.
  std::vector<Eigen::Vector3d> nodes;
  std::vector<Eigen::Vector3d> undeformed;  ///< places of undeformed bodies, joints as they are [m]
  std::vector<Eigen::Matrix3d> undeformed_axes;  ///< axes of undeformed bodies by node: columns
  std::vector<Eigen::Vector3d> rotations;        ///< of nodes from these axes, rotation vectors
  std::vector<int> bodies;                       ///< of the nodes, from 0
  std::vector<SolidDeformation> solids;          ///< of the bodies that are solids
  std::vector<SectionAir> air;                   ///< by station; empty: no air acts
  /// For each body its largest deflection across its axis by its length; 0 for rigid ones.
  std::vector<double> bending;
};

/// Where the hub of a rotor on a support is at azimuth zero, in the frame of what that stands on.
struct HubPlace {
  Eigen::Vector3d position{0.0, 0.0, 0.0};             ///< of its origin [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns; z is the axis of rotation
};

/// One of several rotors on a support in equilibrium.
struct RotorEquilibrium {
  std::string name;
  double speed = 0.0;  ///< of its hub [rad/s]
  HubPlace hub;
  /// Force of support and drive on its hub, hub frame [N].
  Eigen::Vector3d force{0.0, 0.0, 0.0};
  Eigen::Vector3d moment{0.0, 0.0, 0.0};       ///< moment about its origin, hub frame [N m]
  std::optional<RotorAir> air = std::nullopt;  ///< none: no air acts
};

/// What small motions about an equilibrium do.
enum class SmallMotions {
  decay,
  persist,  ///< without damping they go on as they are
  grow,     ///< the equilibrium is unstable: a run leaves it
};

/// Whether an equilibrium is stable, by the lowest roots of small motions about it.
struct Stability {
  SmallMotions motions = SmallMotions::persist;
  /// Real part of the root that decays least, or grows most [1/s].
  double rate = 0.0;
  double frequency = 0.0;  ///< of that motion [rad/s]
  std::string mode;        ///< its name, as `spoke modes` has it
  std::string of;          ///< whose it is: "blade 1"
};

/// A model in equilibrium. Of several rotors, what is said of the hub is that of the first.
struct EquilibriumResult {
  double speed = 0.0;  ///< of the hub [rad/s]
  /// And behind them other subsystems; a support is the last, and its vectors are in the frame of
  /// what it stands on.
  std::vector<BladeEquilibrium> blades;
  std::optional<HubPlace> hub = std::nullopt;  ///< of a rotor on a support
  /// Force of support and drive on the hub, hub frame [N].
  Eigen::Vector3d hub_force{0.0, 0.0, 0.0};
  Eigen::Vector3d hub_moment{0.0, 0.0, 0.0};   ///< moment about its origin, hub frame [N m]
  std::optional<RotorAir> air = std::nullopt;  ///< none: no air acts
  std::vector<RotorEquilibrium> rotors{};      ///< of several on a support all; else empty
  /// None: not known, where matrices are periodic or loops are in a singular position.
  std::optional<Stability> stability = std::nullopt;
  std::string stability_unknown{};  ///< why it is not known; empty: it is
  int iterations = 0;               ///< of Newton's method, for all blades
  int load_steps = 1;               ///< number of steps in which loads were applied
  double last_change = 0.0;  ///< change of a coordinate in the last iteration [rad, or by length]
  /// Reasons to doubt it: a body that bends beyond `limits.deflection`.
  std::vector<Warning> warnings{};
};

/// Finds the equilibrium of a scenario's model in steady rotation or at rest, by Newton's method
/// with a line search and, where needed, load steps. Loads, motors and prescribed joints have the
/// values with which their curves end, pitch that follows the azimuth its mean. Where the hub
/// turns, gravity and loads of constant direction count with their part along the axis, since their
/// other parts turn against the model; on a support their mean acts through the hub. Throws
/// InputError if the scenario is not valid, if the speed is not finite, if the drive is a torque
/// and no speed is given, or if nothing holds the hub or a joint; DivergenceError, naming body and
/// coordinate, if no equilibrium is found.
SPOKE_EXPORT EquilibriumResult solve_equilibrium(const Scenario& scenario,
                                                 const SteadyState& state = {});
/// Finds the equilibrium of the model of a simulation, with the drive in force; loads of the user's
/// own do not count.
SPOKE_EXPORT EquilibriumResult solve_equilibrium(const Simulation& simulation,
                                                 const SteadyState& state = {});

}  // namespace spoke
