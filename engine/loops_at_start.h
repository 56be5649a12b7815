#pragma once

// What the start of a simulation made of closed loops.

#include <string>
#include <vector>

namespace spoke {

/// A joint that was moved from its initial coordinates so that loops are closed.
struct MovedJoint {
  std::string joint{};  ///< "blade 1 / pitch"
  double by = 0.0;      ///< of a spherical joint the angle of its rotation
  std::string unit{};   ///< "rad" or "m"
};

/// A coordinate of a joint whose speed was changed so that loops stay closed.
struct ChangedSpeed {
  std::string joint{};  ///< "blade 1 / pitch"
  double from = 0.0;    ///< initial_speed
  double to = 0.0;      ///< speed at the start
  std::string unit{};   ///< "rad/s" or "m/s"
};

/// The freedoms of a blade or subsystem that has loops.
struct SubsystemFreedoms {
  std::string name{};    ///< "blade 1"
  int joints = 0;        ///< free coordinates of joints
  int deformations = 0;  ///< coordinates of deformations
  int rows = 0;          ///< directions that its loops lock, those that give not counted
  int independent = 0;   ///< those that are not redundant
  int mobility = 0;      ///< free coordinates less independent rows
};

/// All of that.
struct LoopsAtStart {
  std::vector<SubsystemFreedoms> subsystems{};  ///< with loops, in the order of the scenario
  std::vector<std::string> redundant{};         ///< "ring / hinge_6: displacement along x"
  std::vector<MovedJoint> moved{};              ///< in the order of subsystems and bodies
  std::vector<ChangedSpeed> speeds{};           ///< likewise
};

}  // namespace spoke
