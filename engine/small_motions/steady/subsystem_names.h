#pragma once

// Names of subsystems and their parts.

#include <string>
#include <vector>

#include "models/rotor.h"
#include "models/tree/tree.h"

namespace spoke {

/// Names of a subsystem, its bodies, and the joints that carry them.
struct SubsystemNames {
  std::string name;
  std::vector<std::string> bodies;
  std::vector<std::string> joints;
  std::string sensors;   ///< prefix of the names of its sensors: "blade1"
  double azimuth = 0.0;  ///< [rad]
};

/// Returns names of subsystems as "blade 1", "blades 1 to 3" or "blade 1, blade 3".
std::string join_names(const std::vector<std::string>& names);

/// Names the blades of a rotor in the plane, whose joints have no names.
std::vector<SubsystemNames> name_subsystems(const Rotor& rotor);
std::vector<SubsystemNames> name_subsystems(const std::vector<spatial::Tree>& trees);

}  // namespace spoke
