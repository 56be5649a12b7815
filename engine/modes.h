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

/// Which modes.
struct ModeOptions {
  SteadyState state{};  ///< about which
  /// How many, from the lowest frequency on: of each blade where blades do not couple, because the
  /// hub's motion is prescribed, else of the whole model. 1 or more; none: 10, or as many as there
  /// are.
  std::optional<int> count = std::nullopt;
};

/// A vibration mode: motion Re(shape exp(eigenvalue t)) about the equilibrium, in the frame that
/// turns with the hub.
struct Mode {
  std::string name;  ///< by what moves most: "flap 1", "lag_hinge", "collective lag 1"
  std::string kind;  ///< "flap", "lag", "axial", "torsion", a joint's name, "hub"
  /// Whose: "blade 1", "blades 1 to 3" that are alike, "all" where blades couple.
  std::string of;
  std::complex<double> eigenvalue;  ///< [rad/s]
  double frequency = 0.0;           ///< of the motion, the imaginary part [rad/s]
  double damping_ratio = 0.0;       ///< less the real part by the magnitude; negative: it grows
  /// By blade, then other subsystems: displacement of each node, hub frame, the largest of all
  /// being 1; empty for a blade that is not in it.
  std::vector<std::vector<Eigen::Vector3cd>> shape;
  /// Rotations of the same nodes in the same motion, hub frame [rad/m].
  std::vector<std::vector<Eigen::Vector3cd>> rotations;
  /// Motion of the hub's frame in it, with which the nodes go; zero where it is prescribed.
  Eigen::Vector3cd hub_displacement = Eigen::Vector3cd::Zero();
  Eigen::Vector3cd hub_rotation = Eigen::Vector3cd::Zero();  ///< likewise [rad/m]
  /// Coordinates in the model's own order, and those of the hub that are free, before them.
  Eigen::VectorXcd coordinates;

  /// Whether it grows: the equilibrium is unstable. Less than 1e-6 of the eigenvalue is round-off:
  /// that of rigid motions, which go on at a constant rate, has its square root.
  bool grows() const { return eigenvalue.real() > 1e-6 * std::abs(eigenvalue); }
};

/// Modes of a model.
struct ModesResult {
  EquilibriumResult equilibrium;  ///< about which; of a free hub without supports, too
  bool are_blades_coupled = false;
  std::vector<Mode> modes;  ///< by ascending magnitude of the eigenvalue; uncoupled: blade by blade
};

/// Finds the lowest modes of a scenario's model about its equilibrium (solve_equilibrium()), in the
/// frame that turns with the hub, where the linearised system is constant (docs/modes.md). Throws
/// like solve_equilibrium(), but for what nothing holds: that is a mode of frequency zero. Throws
/// InputError if fewer modes exist than are asked for, or if forces on a free hub are not in
/// balance.
SPOKE_EXPORT ModesResult solve_modes(const Scenario& scenario, const ModeOptions& options = {});

}  // namespace spoke
