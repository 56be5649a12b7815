#pragma once

// What trees and their parts are called.

#include <string>
#include <vector>

#include "models/rotor.h"
#include "models/tree/tree.h"

namespace spoke {

/// Names of a tree: its own, those of its bodies and of the joints that carry them.
struct TreeNames {
  std::string tree;
  std::vector<std::string> bodies;
  std::vector<std::string> joints;
  std::string sensors;   ///< what the names of its sensors begin with: "blade1"
  double azimuth = 0.0;  ///< [rad]
};

/// Of the blades of a rotor in the plane, whose joints have no names.
std::vector<TreeNames> name_trees(const Rotor& rotor);
std::vector<TreeNames> name_trees(const std::vector<spatial::Tree>& trees);

}  // namespace spoke
