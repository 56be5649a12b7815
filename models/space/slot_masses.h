#pragma once

// What couples the slots of a body, and what its coordinates count in its momentum.

#include <array>
#include <vector>

#include "models/space/beam_element.h"

namespace spoke::space {

/// The slots of a body. Their components are multiplied by one constant scalar matrix m, whatever
/// the direction, so that no motion of the frame can deform the body. The slots of a node are its
/// place and its axes along x, y, z of B; what an element's stretch adds to the tangents at its two
/// nodes is a slot of the element, sigma = e1 e1.(u_2 - u_1)/l.
struct SlotMasses {
  using NodeBlock = std::array<double, kNodeSlots * kNodeSlots>;  ///< row by row [kg, kg m, kg m^2]
  std::vector<NodeBlock> own;                                     ///< of a node with itself
  std::vector<NodeBlock> next;  ///< rows of node e, columns of node e + 1
  /// Row of an element's stretch: with the slots of its inner and of its outer node.
  std::vector<std::array<double, kElementSlots>> stretch;
  std::vector<double> stretch_own;
};

/// C_t of a node: how its coordinates' accelerations count in the body's momentum (transposed).
using NodeMomentum = Eigen::Matrix<double, kTwist, 3, Eigen::DontAlign>;

}  // namespace spoke::space
