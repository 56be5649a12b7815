#pragma once

// A model linearised about its steady rotation, in the frame that turns with the hub:
// M x'' + C x' + K x = 0, with constant matrices.

#include <optional>
#include <string>
#include <vector>

#include "engine/small_motions/steady/find_equilibrium.h"

namespace spoke::steady {

/// The hub's motion in coordinates x of the steady frame. Besides the steady ones, its twist is x'
/// + W x, and its acceleration, by which the mass matrix is multiplied, x'' + P1 x' + P0 x. W =
/// diag(w~, w~), P1 = diag(2 w~, w~), P0 = diag(w~ w~, 0); in the plane the angle is in none of
/// them.
struct HubKinematics {
  Eigen::MatrixXd W, P0, P1;
};
HubKinematics make_hub_kinematics(const SteadyModel& model);

/// Round-off of C and K, which are differences of forces: for each coordinate the size of the terms
/// that make up the force on it (they may cancel), and the step by which it was moved.
struct RoundOff {
  Eigen::VectorXd force;  ///< [N, N m]
  Eigen::VectorXd step;   ///< [m, rad]
};

/// Matrices of one subsystem alone while the hub is held, of its independent coordinates y: of all,
/// unless it has loops, by which the others follow these. Where joints relax (ForceState), their z
/// are among y, each behind the coordinate on which it acts: z' = (k q - z)/T, with next to no mass
/// that leaves its root of no interest far away.
struct LinearSubsystem {
  Eigen::MatrixXd M, C, K;
  RoundOff round_off;
  /// Numbers of the coordinates y; of a force that of the coordinate on which it acts.
  std::vector<Eigen::Index> independent{};
  std::vector<Eigen::Index> forces{};  ///< places of the forces z among y, ascending
  /// Z, by which y moves all coordinates: q = Z y; empty: q = y.
  Eigen::MatrixXd basis{};
  /// Sizes of the terms of which K consists, in the place of |K|; empty: |K|.
  Eigen::MatrixXd K_terms{};
};

/// Coupling of a subsystem with the hub's free coordinates. `bh`: rows of the subsystem, columns of
/// the hub; `hb`: rows of the hub, columns of the subsystem.
struct HubCoupling {
  Eigen::MatrixXd M_bh, C_bh, K_bh;
  Eigen::MatrixXd M_hb, C_hb, K_hb;
  /// G, by which loops on the mount move coordinates with the hub: q = Z y + G x; empty: none do.
  Eigen::MatrixXd following{};
};

/// A support that moves the hubs of rotors: small motions z of its base, if that is free, of its
/// independent coordinates, and of the axles that turn freely.
struct LinearSupport {
  /// By it z moves the hubs, x = J z, each along the axes that it has at azimuth zero but which
  /// stand: six rows by rotor.
  Eigen::MatrixXd J{};
  Eigen::MatrixXd M{}, C{}, K{};  ///< of the support alone, on which the steady wrenches act
  Eigen::MatrixXd rotor_mass{};   ///< of the rotors as rigid bodies, along the hubs' axes
  Eigen::MatrixXd base{};         ///< by which z moves the base, a twist
  Eigen::MatrixXd motion{};       ///< by which z moves all coordinates of the support
  Eigen::VectorXd step{};         ///< by which each of z was moved [m, rad]
  /// By rotor: its axle's entry of z; none: the axle does not turn freely.
  std::vector<std::optional<Eigen::Index>> axles{};
  /// By rotor: along which the torque of its drive acts, that of the axle or of its generator; zero
  /// if a drive prescribes the motion.
  std::vector<Eigen::VectorXd> drives{};
  std::vector<std::string> of{};       ///< by entry of z: the body, or the joint, that it moves
  std::vector<std::string> names{};    ///< of the entries: "support / tower / node 3 / w"
  std::vector<std::string> units{};    ///< of the entries
  std::vector<Eigen::Index> forces{};  ///< entries that are forces, see LinearSubsystem
};

/// The matrices of a model. Subsystems meet at the hub only, whose free coordinates are small
/// motions in its steady frame: places and rotations. There are none where support and drive
/// prescribe its motion. Of several rotors on a support the hubs' coordinates follow one another.
struct LinearModel {
  Eigen::MatrixXd M, C, K;  ///< of the hub's free coordinates
  std::vector<LinearSubsystem> subsystems;
  std::vector<HubCoupling> couplings;  ///< by subsystem, if the hub has free coordinates
  /// For each subsystem the one whose matrices stand for it: those that are alike are linearised
  /// once, and the entries of the others are empty.
  std::vector<std::size_t> alike;
  RoundOff round_off = {};  ///< of the hub's free coordinates
  double rate = 1.0;        ///< velocities were moved by `rate` times the steps [1/s]
  /// What carries the hub. The support is the last subsystem, all of whose coordinates follow
  /// (HubCoupling::following) those of the hub once the rotor stands on it.
  std::optional<LinearSupport> support = std::nullopt;

  bool is_coupled() const { return M.rows() > 0; }
  const LinearSubsystem& subsystem(std::size_t i) const { return subsystems[alike[i]]; }
  /// Returns the motion of all coordinates of a subsystem, for one of its independent coordinates
  /// and of the hub.
  Eigen::VectorXcd motion_of(std::size_t i, const Eigen::VectorXcd& y,
                             const Eigen::VectorXcd& hub) const;
};

/// Returns the independent coordinates of a subsystem, forces among them, in their order.
std::vector<SubsystemCoordinate> list_independent(std::size_t subsystem, const LinearModel& linear,
                                                  const SteadyModel& model);
/// Whether forces of relaxing joints are among the coordinates of a model.
bool has_forces(const LinearModel& linear);

/// Which components of the hub's motion are coordinates of a linear model.
enum class HubFreedom {
  described,  ///< those that the model leaves free
  /// All, as if the hub stood on something that moves: rows are the force and the moment about the
  /// moved hub's origin that what holds the hub must balance besides the steady ones, along steady
  /// axes. The steady ones stay along these axes, so that K holds their turning with the rotor.
  /// Of a drive that is a torque, its slope acts between the hub and steady rotation.
  all,
};

/// Returns the components that are coordinates: of 3 in the plane, of 6 in space.
std::vector<int> list_components(const SteadyModel& model, HubFreedom freedom);

/// Linearises a model about its equilibrium, at which it leaves the model. M is the mass matrix
/// there; K and D of deformations are the model's own constants; the rest of K and C are
/// differences of the forces, see calc_derivatives(). Of loops only the motions count that leave
/// their rigid rows closed, with the forces of these rows held. Throws InputError if loops hold the
/// hub.
LinearModel linearize(const Equilibrium& equilibrium, SteadyModel& model,
                      HubFreedom freedom = HubFreedom::described);

}  // namespace spoke::steady
