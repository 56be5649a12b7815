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
  /// Kinetic energies: along x, y (lag), z (flap) of the tree's root, and of rotation about x.
  std::array<double, 4> energies{};
  double total() const { return energies[0] + energies[1] + energies[2] + energies[3]; }
};

/// The motion of a tree by its coordinates `x` about its equilibrium q, relative to the hub. Leaves
/// the model at q.
TreeShape calc_tree_shape(std::size_t tree, const Eigen::VectorXd& q, const Eigen::VectorXcd& x,
                          steady::SteadyModel& model);

/// "flap", "lag", "axial" or "torsion", by the largest energy; before it the name of the joint that
/// has more than half of the kinetic energy x^H M x by itself, if there is one: "hinges flap", or
/// only "flap_hinge" where the name says it.
std::string name_kind(std::size_t tree, const Eigen::VectorXcd& x, const Eigen::MatrixXd& mass,
                      const TreeShape& shape, const steady::SteadyModel& model);

/// How equal blades move together: their amplitudes, by the blade that moves most, as sums over
/// multiples n of the azimuth. "collective" (0), "progressive", "regressive" (whirl with and
/// against the rotation), "cosine" and "sine" (both alike), "differential" (N/2), "order n" with
/// its sense. Empty if there are less than two blades, or their amplitudes are no such pattern.
std::string name_pattern(const std::vector<Eigen::VectorXcd>& blades,
                         const std::vector<double>& azimuths);

}  // namespace spoke::vibration
