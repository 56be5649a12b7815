#pragma once

// Elimination of the joints of a tree, from its tips to the root: the block elimination of
// Phi M^-1 Phi^T, (P 8) and (P 10), once for plane and space (docs/formulation.md, sections 4.1
// and 11).
//
// The joint of a child at handle o of its parent, R from the child's frame to the parent's, p from
// the handle to the child's origin, X = [1, p~; 0, 1], all in the parent's frame, ' of the child:
//   Pi = (P_oo + X R Lambda' R^T X^T)^-1,    r = X (R free' - bias) - free_o
//   f  = Pi r                                  on the handle, if no other handle has a wrench
//   P_ab -= P_ao Pi P_ob,                    free_a += P_ao f           of all other handles a, b
// Pi and f change by JointResponse if the joint has coordinates. A body without children left is a
// branch: Lambda = P_ii, free = free_i.
//
// A joint is what has the member R and, in worlds whose joints have coordinates, p, bias and
// columns (of the coordinates; both at the child's origin, in the parent's frame), coordinates
// (their number n), tau and share. Of a root joint, R and p lead to the hub's frame, and all have p
// and bias.

#include <cassert>

#include "engine/bodies/tree/joint_coordinates.h"
#include "engine/bodies/tree/multi_port.h"
#include "models/plane/plane.h"
#include "models/space/vectors.h"

namespace spoke::tree {

/// Joints without coordinates keep nothing.
template <class World, bool has_coordinates = kHasJointCoordinates<World>>
struct ResponseOfJoint {};
template <class World>
struct ResponseOfJoint<World, true> {
  JointResponse<World> response;
};

/// Quantities of a joint that recovery needs: its wrench on the parent is f = Pi (rhs - sum of P_oh
/// f_h), over the other handles h of the parent, and response.wrench.
template <class World>
struct JointElimination : ResponseOfJoint<World> {
  typename World::SymmetricTwistMatrix Pi;
  typename World::Twist rhs;
};

/// Eliminates the joint of `child` at a handle of compliance P_oo and acceleration free_o. Returns
/// the wrench on the handle if all others have none.
template <class World, class Joint>
[[gnu::always_inline]] inline typename World::Twist eliminate_joint(
    const typename World::SymmetricTwistMatrix& P_oo, const typename World::Twist& free_o,
    const Joint& joint, const Branch<World>& child, JointElimination<World>& elimination) noexcept {
  using Twist = typename World::Twist;
  typename World::SymmetricTwistMatrix Lambda = rotate(joint.R, child.Lambda);
  Twist free = joint.R * child.free;
  if constexpr (kHasJointCoordinates<World>) {
    free -= joint.bias;
    if (!joint.p.isZero(0.0)) {  // zero where a beam goes on
      Lambda = refer(joint.p, Lambda);
      free = refer(joint.p, free);
    }
  }
  elimination.Pi = invert(P_oo + Lambda);
  elimination.rhs = free - free_o;
  if constexpr (kHasJointCoordinates<World>) {
    JointResponse<World>& response = elimination.response;
    for (int c = 0; c < joint.coordinates; ++c)
      response.H.col(c) = refer(joint.p, joint.columns.col(c));
    eliminate_coordinates(joint, elimination.Pi, response);
    return elimination.Pi * elimination.rhs + response.wrench;
  } else {
    return elimination.Pi * elimination.rhs;
  }
}

/// Returns the branch that a body with two handles becomes when the joint at its outboard one is
/// eliminated with Pi and f.
template <class World>
Branch<World> join(const typename World::SymmetricTwistMatrix& P_ii,
                   const typename World::TwistMatrix& P_io, const typename World::Twist& free_i,
                   const typename World::SymmetricTwistMatrix& Pi,
                   const typename World::Twist& f) noexcept {
  return {eliminate(P_ii, P_io, Pi), free_i + P_io.lazyProduct(f)};
}

/// Eliminates the joint at handle `o` of a body whose handles behind o are eliminated: changes the
/// multi-port at the handles before. Its row P_oh stays, for recovery.
template <class World, class Joint>
[[gnu::always_inline]] inline void eliminate_child(int o, const Joint& joint,
                                                   const Branch<World>& child,
                                                   const MultiPort<World>& port,
                                                   JointElimination<World>& elimination) noexcept {
  assert(o > 0 && o < port.handles);
  using Matrix = typename World::TwistMatrix;
  const typename World::Twist f =
      eliminate_joint(port.diagonal[o], port.free[o], joint, child, elimination);
  for (int a = 0; a < o; ++a) {
    const Matrix& P_ao = port.between(a, o);
    port.diagonal[a] = eliminate(port.diagonal[a], P_ao, elimination.Pi);
    port.free[a] += P_ao.lazyProduct(f);
    if (a + 1 == o) break;
    const Matrix P_ao_Pi = P_ao.lazyProduct(elimination.Pi.matrix());
    for (int b = a + 1; b < o; ++b)
      port.between(a, b) -= P_ao_Pi.lazyProduct(port.between(b, o).transpose());
  }
}

/// Quantities of a root joint that recovery needs.
template <class World>
struct RootElimination : ResponseOfJoint<World> {
  typename World::SymmetricTwistMatrix
      mass;                    ///< Lambda^-1, less the yield of the joint's coordinates
  typename World::Twist free;  ///< acceleration of the root handle without wrench
};

/// A subsystem as the hub feels it, (P 10), in the hub frame.
template <class World>
struct HubShare {
  typename World::SymmetricTwistMatrix mass;  ///< M^C
  typename World::Twist force;                ///< Q^C
};

/// Eliminates the root joint of a subsystem, the one at the hub:
///   M^C = T^T R Pi R^T T,   Q^C = T^T R Pi R^T (R free - bias),   T = [1, -p~; 0, 1]
template <class World, class Joint>
[[gnu::always_inline]] inline HubShare<World> eliminate_root(
    const Joint& joint, const Branch<World>& branch, RootElimination<World>& root) noexcept {
  using Twist = typename World::Twist;
  root.mass = invert(branch.Lambda);
  root.free = branch.free;
  if constexpr (kHasJointCoordinates<World>) {
    JointResponse<World>& response = root.response;
    for (int c = 0; c < joint.coordinates; ++c)
      response.H.col(c) = joint.R.inverse() * Twist(joint.columns.col(c));
    eliminate_coordinates(joint, root.mass, response);
  }
  const typename World::SymmetricTwistMatrix mass = rotate(joint.R, root.mass);
  Twist force = mass * Twist(joint.R * root.free - joint.bias);
  if constexpr (kHasJointCoordinates<World>) force += joint.R * root.response.wrench;
  return {translate(joint.p, mass), translate(joint.p, force)};
}

}  // namespace spoke::tree
