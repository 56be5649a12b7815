#pragma once

// Couplings: linear relations between coordinates of joints, as gears, racks, belts and
// differentials make.

#include <string>
#include <vector>

namespace spoke {

/// A coordinate in a coupling.
struct CoupledJoint {
  std::string joint{};  ///< name of a joint of the subsystem, which is free or prescribed
  int coordinate = 1;   ///< its coordinate, from 1
  double ratio = 0.0;   ///< c, not 0 [1/rad, 1/m, or without unit for all of one coupling]
  /// Where the joint is if not on the blade or subsystem whose coupling it is: the number of a
  /// blade, from 1, or the name of a subsystem; but for one coordinate at least.
  int blade = 0;
  std::string subsystem{};

  bool is_elsewhere() const { return blade != 0 || !subsystem.empty(); }
};

/// Keeps sum c (q - q_0) = 0 over coordinates q of joints, which are q_0 in the scenario at t = 0.
/// On each of them acts the effort c times the force of the coupling.
struct Coupling {
  std::string name{};                  ///< name, unlike that of any other of the subsystem
  std::vector<CoupledJoint> joints{};  ///< two or more; one of them at least is free
  /// Of a spring in place of the rigid relation: its energy is stiffness (sum)^2/2; 0: rigid.
  double stiffness = 0.0;
  double damping = 0.0;  ///< of a damper beside the spring; a rigid one has none
};

}  // namespace spoke
