#pragma once

// Recovery of the wrenches of the joints, the multipliers of (P 8), from the root of a tree
// outward, and of the accelerations of the joints' coordinates.

#include <cassert>

#include "engine/bodies/tree/joint_elimination.h"

namespace spoke::tree {

/// Returns the wrench on the root handle, in its body's frame, from the acceleration that the hub
/// gives it: R^T (T Y'' + bias), in the same frame. `a`: accelerations of the joint's coordinates,
/// if it has any.
template <class World, class Joint>
typename World::Twist recover_root(const Joint& joint, const RootElimination<World>& root,
                                   const typename World::Twist& acceleration,
                                   double* a = nullptr) noexcept {
  if constexpr (kHasJointCoordinates<World>) {
    const typename World::Twist r = root.free - acceleration;
    recover_coordinates(root.response, r, joint.coordinates, a);
    return -(root.mass * r + root.response.wrench);
  } else {
    return root.mass * (acceleration - root.free);
  }
}

/// Returns the wrench on a parent's handle from `r`, the rest of elimination.rhs when the wrenches
/// on its other handles are known.
template <class World, class Joint>
typename World::Twist recover_joint(const Joint& joint, const JointElimination<World>& elimination,
                                    const typename World::Twist& r, double* a = nullptr) noexcept {
  if constexpr (kHasJointCoordinates<World>) {
    recover_coordinates(elimination.response, r, joint.coordinates, a);
    return elimination.Pi * r + elimination.response.wrench;
  } else {
    return elimination.Pi * r;
  }
}

/// Returns the wrench on handle `o` of a body, with those on the handles before, f[0] ... f[o - 1],
/// known. (Children are recovered in the reverse of the order in which they were eliminated.)
template <class World, class Joint>
[[gnu::always_inline]] inline typename World::Twist recover_child(
    int o, const Joint& joint, const MultiPort<World>& port,
    const JointElimination<World>& elimination, const typename World::Twist* f,
    double* a = nullptr) noexcept {
  assert(o > 0 && o < port.handles && f);
  typename World::Twist r = elimination.rhs;
  for (int h = 0; h < o; ++h) r = r - port.between(h, o).transpose().lazyProduct(f[h]);
  return recover_joint(joint, elimination, r, a);
}

/// Returns the wrench on a child's inboard handle, in its frame, from that on the parent's handle.
template <class World, class Joint>
typename World::Twist pass_to_child(const Joint& joint, const typename World::Twist& f) noexcept {
  if constexpr (kHasJointCoordinates<World>)
    return -(joint.R.inverse() * translate(-joint.p, f));
  else
    return -(joint.R.inverse() * f);
}

/// Returns the wrench on the parent's handle, in its frame, from that on the child's inboard
/// handle.
template <class World, class Joint>
typename World::Twist pass_to_parent(const Joint& joint, const typename World::Twist& F) noexcept {
  typename World::Twist f = -(joint.R * F);
  if constexpr (kHasJointCoordinates<World>)
    return translate(joint.p, f);
  else
    return f;
}

}  // namespace spoke::tree
