#pragma once

// Names and shapes of modes, from their coordinates.

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/eigenvalues.h"

namespace spoke::vibration {

/// Motion of a subsystem in a mode.
struct SubsystemShape {
  std::vector<Eigen::Vector3cd> nodes;      ///< displacements, hub frame [m]
  std::vector<Eigen::Vector3cd> rotations;  ///< rotations of the same nodes [rad]
  std::vector<int> bodies;                  ///< of the nodes
  std::vector<Eigen::VectorXcd> solids;     ///< motions of the coordinates of its solids
  /// By node, motion times the square root of its mass: along x, y (lag) and z (flap) of the root
  /// of the subsystem, and rotation about x.
  std::array<Eigen::VectorXcd, 4> motions{};
  /// By node, displacement of the mass and rotation in the hub's frame, each times the square root
  /// of its mass or inertia: six entries.
  Eigen::VectorXcd weighed{};
  std::array<double, 4> energies{};  ///< kinetic energies of these motions
  double total() const { return energies[0] + energies[1] + energies[2] + energies[3]; }
};

/// Returns the motion of a subsystem relative to the hub, for the coordinates `x` of a mode about
/// its equilibrium q. Leaves the model at q.
SubsystemShape calc_subsystem_shape(std::size_t subsystem, const Eigen::VectorXd& q,
                                    const Eigen::VectorXcd& x, steady::SteadyModel& model);

/// Names kinds of modes, in ascending order of their roots.
class KindNames {
 public:
  /// Returns "flap", "lag", "axial" or "torsion", by the largest energy. Before it stands the name
  /// of the joint, if any, that has more than half of the kinetic energy x^H M x: "hinges flap", or
  /// only "flap_hinge" where the name says it. Of two modes with as much flap as lag, the whirls of
  /// equal stiffnesses, the first is flap, the second lag.
  /// `x` and `mass` are of the independent coordinates, which `coordinates` lists.
  std::string name(const std::vector<steady::SubsystemCoordinate>& coordinates,
                   const Eigen::VectorXcd& x, const Eigen::MatrixXd& mass,
                   const SubsystemShape& shape);

 private:
  std::string find_direction(const std::array<double, 4>& energies);

  bool is_second_ = false;
};

/// Names the pattern of subsystems that are alike: their amplitudes, by the one that moves most, as
/// sums over multiples n of the azimuth. "collective" (0), "progressive" and "regressive" (whirl
/// with and against the rotation), "cosine" and "sine" (standing patterns), "differential" (N/2),
/// "order n" with its sense. Empty if there are fewer than two subsystems, or their amplitudes form
/// no such pattern.
std::string name_pattern(const std::vector<Eigen::VectorXcd>& subsystems,
                         const std::vector<double>& azimuths);

}  // namespace spoke::vibration
