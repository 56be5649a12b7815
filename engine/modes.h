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

/// From where vibrations are seen.
enum class ModeFrame {
  turning,  ///< the frame that turns with the hub
  /// The frame that stands, in multi-blade coordinates: a blade's frequency w is w where all move
  /// alike, w + n W and |w - n W| in patterns that go round n times, at the speed W of the hub. Of
  /// round shafts, too, with any bearings.
  fixed,
  /// The hub in the frame that stands and blades in the one that turns, where matrices are
  /// periodic: for any blades, by Floquet's theory. Gravity and loads of constant direction across
  /// the axis of a hub on an axle count, unless there are closed loops or spherical joints.
  floquet,
};

/// Steady motion and number of modes.
struct ModeOptions {
  SteadyState state{};  ///< about which the model vibrates
  /// Number of modes, from the lowest frequency on: of each blade if blades do not couple, because
  /// the motion of the hub is prescribed; otherwise of the whole model. 1 or more; none: 10, or as
  /// many as there are. In the other frames: of the whole model.
  std::optional<int> count = std::nullopt;
  /// None: `fixed` for a rotor on a support and for shafts in bearings, else `turning`. A rotor
  /// that has no modes in that frame, of two blades or unequal ones, has them in `turning` at rest
  /// and where they are constant there, else in `floquet`; a note says so.
  std::optional<ModeFrame> frame = std::nullopt;
};

/// Where the kinetic energy of a mode is, in shares of its sum over lumped masses: of the motions
/// of subsystems relative to the hub, in the axes of their roots, and of the motion of the model as
/// a rigid body with its hub.
struct ModeEnergy {
  double flap = 0.0, lag = 0.0, axial = 0.0, torsion = 0.0;
  double hub = 0.0;
  double support = 0.0;        ///< of the motions of the bodies of a support
  std::vector<double> bodies;  ///< of the motions relative to the hub, by ModesResult::bodies
};

/// A part of a mode whose matrices are periodic: amplitude exp((s + i k W) t) at the speed W.
struct ModeHarmonic {
  int multiple = 0;        ///< k; 0: the strongest, whose frequency is the mode's
  double frequency = 0.0;  ///< |w + k W| [rad/s]
  double share = 0.0;      ///< of the sum of amplitudes' masses
  double of_hub = 0.0;     ///< that share of it which the hub has
};

/// The motion of a hub's frame in a mode, in its own axes.
struct HubShape {
  Eigen::Vector3cd displacement = Eigen::Vector3cd::Zero();
  Eigen::Vector3cd rotation = Eigen::Vector3cd::Zero();  ///< [rad/m]
};

/// A vibration mode: motion Re(shape exp(eigenvalue t)) about the equilibrium, in the frame that
/// turns with the hub. In the frame `fixed` its shape is that of the hub and, by blade, the motion
/// that blades have when they pass the place where the blade is at t = 0.
struct Mode {
  /// After the largest motion: "flap 1", "lag_hinge", "collective lag 1"; in the other frames
  /// "lag 1 collective". Of several rotors with those that move most: "tail: lag 1 collective",
  /// "front + rear: flap 1 collective".
  std::string name;
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
  /// Of several rotors on a support, the same of each, that of the first again; else empty.
  std::vector<HubShape> hubs;
  /// Free coordinates of the hub, then all others in the order of the model; in the frame `fixed`
  /// multi-blade coordinates, conjugate where blades have a negative frequency.
  Eigen::VectorXcd coordinates;
  /// The same motion of lumped masses relative to the hub, of the subsystems that move, then of the
  /// hub, each times the square root of its mass or inertia: a product of two modes is by mass.
  Eigen::VectorXcd weighed;
  ModeEnergy energy;
  /// In the frame `floquet`: harmonics with a share above 1e-6, by ascending multiple. Shape and
  /// energy are those of the strongest.
  std::vector<ModeHarmonic> harmonics;

  /// Whether it grows: the equilibrium is then unstable. A real part below 1e-6 of the eigenvalue
  /// is round-off; the eigenvalues of rigid motions, which go on at a constant rate, are known to
  /// the square root of round-off.
  bool grows() const { return eigenvalue.real() > 1e-6 * std::abs(eigenvalue); }
};

/// Modes of a model.
struct ModesResult {
  EquilibriumResult equilibrium;  ///< may be that of a free hub without supports
  ModeFrame frame = ModeFrame::turning;
  /// Bodies of subsystems, of those that are alike together: "blades 1 to 3 / body 2".
  std::vector<std::string> bodies;
  bool are_blades_coupled = false;
  /// What a reader of the modes should know: a frame that was chosen, air at rest, fewer modes.
  std::vector<std::string> notes;
  std::vector<Mode> modes;  ///< by ascending magnitude of the eigenvalue; uncoupled: blade by blade
};

/// Finds the lowest modes of a scenario's model about its equilibrium (solve_equilibrium()), in the
/// frame that turns with the hub, where the linearised system is constant, or in another one
/// (docs/modes.md). Throws like solve_equilibrium(), except that a motion which nothing holds is a
/// mode of frequency zero. If fewer modes exist than are asked for, a note says so. Throws
/// InputError if forces on a free hub are not in balance, or if the frame is not for such a model;
/// DivergenceError, in the frame `floquet`, if gravity across the axis causes no periodic motion.
SPOKE_EXPORT ModesResult solve_modes(const Scenario& scenario, const ModeOptions& options = {});

}  // namespace spoke
