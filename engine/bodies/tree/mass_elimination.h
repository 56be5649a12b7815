#pragma once

// Elimination of the joints of a tree of rigid bodies by their masses, from its tips to the root
// (docs/formulation.md, section 11). A rigid body needs no inverse of its mass, which is lost to
// rounding where the body can spin with next to no inertia about its centre of mass but its joint
// does not let it: there the compliances of joint_elimination.h are large, and cancel.
//
// A body with all that it carries takes the wrench F = M a - p on its inboard handle, in its frame.
// Of its joint, R, p, bias and H as in joint_elimination.h, at the acceleration a_o of the handle
// that carries it:
//   r = -(X^-1 a_o + bias),  f = M' r + s on the parent, at the child's origin,  X = [1, p~; 0, 1]
// with M' = R M R^T less what the joint's coordinates yield, and s from s_0 = R p
// (joint_coordinates.h). A Branch holds M in the place of Lambda and p in that of free.

#include "engine/bodies/tree/joint_coordinates.h"
#include "models/space/symmetric_twist_matrix.h"
#include "models/space/vectors.h"

namespace spoke::tree {

/// Eliminates the coordinates of the joint of `child`: sets M' and the response, both at the
/// child's origin in the parent's frame.
template <class World, class Joint>
void eliminate_joint_by_mass(const Joint& joint, const Branch<World>& child,
                             typename World::SymmetricTwistMatrix& mass,
                             JointResponse<World>& response) noexcept {
  mass = rotate(joint.R, child.Lambda);
  for (int c = 0; c < joint.coordinates; ++c) response.H.col(c) = joint.columns.col(c);
  eliminate_coordinates(joint, mass, response, typename World::Twist(joint.R * child.free));
}

/// Returns r at the acceleration `a` of the handle that carries the joint.
template <class World, class Joint>
typename World::Twist calc_r(const Joint& joint, const typename World::Twist& a) noexcept {
  return -typename World::Twist(refer(-joint.p, a) + joint.bias);
}

/// Returns what the parent feels at its handle, M' and f at the acceleration `a` of the handle.
template <class World, class Joint>
Branch<World> pass_inward(const Joint& joint, const typename World::SymmetricTwistMatrix& mass,
                          const JointResponse<World>& response,
                          const typename World::Twist& a) noexcept {
  const typename World::Twist f = mass * calc_r<World>(joint, a) + response.wrench;
  return {translate(joint.p, mass), translate(joint.p, f)};
}

/// What recovery finds of a joint.
template <class World>
struct RecoveredJoint {
  typename World::Twist on_parent;  ///< wrench on the parent's handle, in its frame
  typename World::Twist on_child;   ///< wrench on the child's origin, in its frame
  typename World::Twist frame;      ///< acceleration of the child's frame, in it
};

/// Recovers a joint from the acceleration `a_o` of the handle that carries it; sets the
/// accelerations `a` of its coordinates.
template <class World, class Joint>
RecoveredJoint<World> recover_joint_by_mass(const Joint& joint,
                                            const typename World::SymmetricTwistMatrix& mass,
                                            const JointResponse<World>& response,
                                            const typename World::Twist& a_o, double* a) noexcept {
  using Twist = typename World::Twist;
  const Twist r = calc_r<World>(joint, a_o);
  recover_coordinates(response, r, joint.coordinates, a);
  Twist frame = -r;
  for (int c = 0; c < joint.coordinates; ++c) frame += a[c] * response.H.col(c);
  const Twist f = mass * r + response.wrench;
  return {translate(joint.p, f), -(joint.R.inverse() * f), joint.R.inverse() * frame};
}

}  // namespace spoke::tree
