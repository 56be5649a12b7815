#pragma once

// Names and shapes of modes, from their coordinates.

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "engine/steady/find_equilibrium.h"
#include "engine/vibration/eigenvalues.h"

namespace spoke::vibration {

/// How a tree moves in a mode.
struct TreeShape {
  std::vector<Eigen::Vector3cd> nodes;      ///< displacements, hub frame [m]
  std::vector<Eigen::Vector3cd> rotations;  ///< of the same nodes [rad]
  /// By node its motion times the root of its mass: along x, y (lag), z (flap) of the tree's root,
  /// and of rotation about x.
  std::array<Eigen::VectorXcd, 4> motions{};
  std::array<double, 4> energies{};  ///< kinetic ones of these
  double total() const { return energies[0] + energies[1] + energies[2] + energies[3]; }
};

/// The motion of a tree by its coordinates `x` about its equilibrium q, relative to the hub. Leaves
/// the model at q.
TreeShape calc_tree_shape(std::size_t tree, const Eigen::VectorXd& q, const Eigen::VectorXcd& x,
                          steady::SteadyModel& model);

/// Names kinds of modes, in ascending order of their roots.
class KindNames {
 public:
  /// "flap", "lag", "axial" or "torsion", by the largest energy; before it the name of the joint
  /// that has more than half of the kinetic energy x^H M x by itself, if there is one: "hinges
  /// flap", or only "flap_hinge" where the name says it. Of two modes that have as much flap as
  /// lag, the whirls of equal stiffnesses, the first is flap, the second lag.
  std::string name(std::size_t tree, const Eigen::VectorXcd& x, const Eigen::MatrixXd& mass,
                   const TreeShape& shape, const steady::SteadyModel& model);

 private:
  std::string find_direction(const std::array<double, 4>& energies);

  bool is_second_ = false;
};

/// How equal blades move together: their amplitudes, by the blade that moves most, as sums over
/// multiples n of the azimuth. "collective" (0), "progressive", "regressive" (whirl with and
/// against the rotation), "cosine" and "sine" (both alike), "differential" (N/2), "order n" with
/// its sense. Empty if there are less than two blades, or their amplitudes are no such pattern.
std::string name_pattern(const std::vector<Eigen::VectorXcd>& blades,
                         const std::vector<double>& azimuths);

}  // namespace spoke::vibration
