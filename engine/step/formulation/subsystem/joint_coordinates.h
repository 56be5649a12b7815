#pragma once

// The coordinates of joints in the subsystem synthesis. They have no mass: with lambda of the
// bodies' elimination
//   lambda = D^-1 (Phi_Y Y'' + right + R^T H q_J''),     right = Phi M^-1 Q - gamma
//   (R^T H)^T lambda + k^ q_J'' = tau
// they are found from the positive definite
//   ((R^T H)^T D^-1 R^T H + k^) q_J'' = tau - (R^T H)^T D^-1 (Phi_Y Y'' + right)

#include "engine/step/formulation/subsystem.h"
#include "engine/step/formulation/tree_joints.h"

namespace spoke::subsystem {

/// Sets R^T H of the joint of body k in `work.columns`.
template <class World, class Joint>
void place_columns(const Joint& joint, int k, SubsystemWork<World>& work) {
  constexpr int d = World::kTwist;
  if constexpr (tree::kHasJointCoordinates<World>)
    for (int c = 0; c < joint.coordinates; ++c)
      work.columns.template block<d, 1>(d * k, work.first_coordinate[k] + c) =
          joint.R.inverse() * TwistOf<World>(joint.columns.col(c));
}

/// Eliminates them: from D^-1 of the columns of `solution` and `columns`, sets the response of the
/// coordinates, and adds their share to `solution`.
template <class World>
void eliminate_coordinates(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                           SubsystemWork<World>& work) noexcept;

}  // namespace spoke::subsystem
