#pragma once

// The rows of a joint in the constraints of a tree, (P 4), once for plane and space: with R and p
// as in engine/bodies/tree/joint_elimination.h, J_h of the handle that carries the joint, J_i of
// the child's inboard one and b their accelerations at zero accelerations,
//   R^T T (J_h (X, q'')_parent + b_h) - J_i (X, q'')_child - b_i + R^T (H q'' + bias) = 0

#include "models/plane/plane.h"
#include "models/space/space.h"

namespace spoke::tree {

/// Returns R^T T a with T = [1, -p~; 0, 1]: the share of the acceleration `a` of the handle that
/// carries a joint in the acceleration of the child, in the child's frame.
template <class World, class Joint>
typename World::Twist carry_to_child(const Joint& joint, typename World::Twist a) noexcept {
  linear(a) += cross(angular(a), joint.p);
  return joint.R.inverse() * a;
}

/// Returns R^T T.
template <class World, class Joint>
typename World::TwistMatrix carrying_matrix(const Joint& joint) noexcept {
  typename World::TwistMatrix C;
  for (int c = 0; c < World::kTwist; ++c)
    C.col(c) = carry_to_child<World>(joint, typename World::Twist(World::Twist::Unit(c)));
  return C;
}

}  // namespace spoke::tree
