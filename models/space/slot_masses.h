#pragma once

// Masses that couple the slots of a body, and the share of its coordinates in its momentum.

#include <array>
#include <vector>

#include "models/space/beam_element.h"

namespace spoke::space {

/// The slots of a body. Their components are multiplied by one constant scalar matrix m, whatever
/// the direction, so that no motion of the frame can deform the body. The slots of a node are its
/// place and its axes along x, y, z of B; the share of an element's stretch in the tangents at its
/// two nodes is a slot of the element, sigma = e1 e1.(u_2 - u_1)/l.
struct SlotMasses {
  /// Masses between the slots of two nodes, row by row [kg, kg m, kg m^2].
  using NodeBlock = std::array<double, kNodeSlots * kNodeSlots>;
  /// Masses of each node with itself.
  std::vector<NodeBlock> own;
  /// Masses between neighbours: rows of node e, columns of node e + 1.
  std::vector<NodeBlock> next;
  /// Masses of each element's stretch with the slots of its inner and of its outer node.
  std::vector<std::array<double, kElementSlots>> stretch;
  std::vector<double> stretch_own;
};

/// C_t of a node: the momentum of the body per acceleration of the node's coordinates (transposed).
using NodeMomentum = Eigen::Matrix<double, kTwist, 3, Eigen::DontAlign>;

}  // namespace spoke::space
