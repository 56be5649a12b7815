#pragma once

// Vibration modes of a model about its steady motion.

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// Steady motion and number of modes.
struct ModeOptions {
  SteadyState state{};  ///< about which the model vibrates
  /// Number of modes, from the lowest frequency on: of each blade if blades do not couple, because
  /// the motion of the hub is prescribed; otherwise of the whole model. 1 or more; none: 10, or as
  /// many as there are.
  std::optional<int> count = std::nullopt;
};

/// A vibration mode: motion Re(shape exp(eigenvalue t)) about the equilibrium, in the frame that
/// turns with the hub.
struct Mode {
  std::string name;  ///< after the largest motion: "flap 1", "lag_hinge", "collective lag 1"
  std::string kind;  ///< "flap", "lag", "axial", "torsion", a joint's name, "hub"
  /// The blades that it belongs to: "blade 1", "blades 1 to 3" that are alike, "all" where blades
  /// couple.
  std::string of;
  std::complex<double> eigenvalue;  ///< [rad/s]
  double frequency = 0.0;           ///< of the motion, the imaginary part [rad/s]
  double damping_ratio = 0.0;       ///< minus the real part by the magnitude; negative: it grows
  /// By blade, then by other subsystems: displacement of each node, hub frame, scaled to a largest
  /// one of 1; empty for a blade that does not move in this mode.
  std::vector<std::vector<Eigen::Vector3cd>> shape;
  /// Rotations of the nodes in the same motion, hub frame [rad/m].
  std::vector<std::vector<Eigen::Vector3cd>> rotations;
  /// By blade, then by other subsystems: motions of the coordinates of its solids, in the order of
  /// BladeEquilibrium::solids; empty for a blade that does not move in this mode.
  std::vector<std::vector<Eigen::VectorXcd>> solids;
  /// Displacement of the hub's frame in the same motion, with which the nodes go; zero where it is
  /// prescribed.
  Eigen::Vector3cd hub_displacement = Eigen::Vector3cd::Zero();
  Eigen::Vector3cd hub_rotation = Eigen::Vector3cd::Zero();  ///< its rotation [rad/m]
  /// Free coordinates of the hub, then all others in the order of the model.
  Eigen::VectorXcd coordinates;

  /// Whether it grows: the equilibrium is then unstable. A real part below 1e-6 of the eigenvalue
  /// is round-off; the eigenvalues of rigid motions, which go on at a constant rate, are known to
  /// the square root of round-off.
  bool grows() const { return eigenvalue.real() > 1e-6 * std::abs(eigenvalue); }
};

/// Modes of a model.
struct ModesResult {
  EquilibriumResult equilibrium;  ///< may be that of a free hub without supports
  bool are_blades_coupled = false;
  std::vector<Mode> modes;  ///< by ascending magnitude of the eigenvalue; uncoupled: blade by blade
};

/// Finds the lowest modes of a scenario's model about its equilibrium (solve_equilibrium()), in the
/// frame that turns with the hub, where the linearised system is constant (docs/modes.md). Throws
/// like solve_equilibrium(), except that a motion which nothing holds is a mode of frequency zero.
/// Throws InputError if fewer modes exist than are asked for, or if forces on a free hub are not in
/// balance.
SPOKE_EXPORT ModesResult solve_modes(const Scenario& scenario, const ModeOptions& options = {});

}  // namespace spoke
