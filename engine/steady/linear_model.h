#pragma once

// A model linearised about its steady rotation, in the frame that turns with the hub:
// M x'' + C x' + K x = 0, with constant matrices.

#include <vector>

#include "engine/steady/find_equilibrium.h"

namespace spoke::steady {

/// The hub's motion in coordinates x of the steady frame: its twist is x' + W x besides the steady
/// one, its acceleration, which the mass matrix stands before, x'' + P1 x' + P0 x. W = diag(w~,
/// w~), P1 = diag(2 w~, w~), P0 = diag(w~ w~, 0); in the plane an angle is in none of them.
struct HubKinematics {
  Eigen::MatrixXd W, P0, P1;
};
HubKinematics make_hub_kinematics(const SteadyModel& model);

/// What round-off leaves of C and K, which are differences of forces: by coordinate how large the
/// terms are that make up the force on it (they may cancel), and the step by which it was moved.
struct RoundOff {
  Eigen::VectorXd force;  ///< [N, N m]
  Eigen::VectorXd step;   ///< [m, rad]
};

/// Matrices of one tree by itself, the hub held.
struct LinearTree {
  Eigen::MatrixXd M, C, K;
  RoundOff round_off;
};

/// What a tree has to do with the hub's free coordinates. `bh`: rows of the tree, columns of the
/// hub; `hb`: the other way round.
struct HubCoupling {
  Eigen::MatrixXd M_bh, C_bh, K_bh;
  Eigen::MatrixXd M_hb, C_hb, K_hb;
};

/// Trees meet at the hub only, whose free coordinates are small motions in its steady frame: places
/// and rotations. There are none where support and drive prescribe its motion.
struct LinearModel {
  Eigen::MatrixXd M, C, K;  ///< of the hub's free coordinates
  std::vector<LinearTree> trees;
  std::vector<HubCoupling> couplings;  ///< by tree, if the hub has free coordinates
  /// By tree, the tree that stands for it: those that are alike are linearised once, and the others
  /// are empty.
  std::vector<std::size_t> alike;
  RoundOff round_off = {};  ///< of the hub's free coordinates
  double rate = 1.0;        ///< velocities were moved by `rate` times the steps [1/s]

  bool is_coupled() const { return M.rows() > 0; }
  const LinearTree& tree(std::size_t i) const { return trees[alike[i]]; }
};

/// Linearises a model about its equilibrium, which it leaves it at: M as it is there, K and D of
/// deformations the model's own constants, the rest of K and C differences of the forces, see
/// calc_derivatives().
LinearModel linearize(const Equilibrium& equilibrium, SteadyModel& model);

}  // namespace spoke::steady
