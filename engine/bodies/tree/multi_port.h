#pragma once

// The multi-port of a body of a tree, its relation to its neighbours: from the wrenches f_h on its
// handles to their accelerations, a_h = sum over h' of P_hh' f_h' + free_h, all in the body's
// frame. Handle 0 is the inboard one; at each other handle hangs one child. (Two children at one
// place are two handles.)
//
// Written for any world: `World` names the types of the plane or of space, as Space does. Joints of
// worlds with World::kMostJointCoordinates = 0 are rigid, and connect a handle to its child's
// origin.

#include <cassert>

namespace spoke::tree {

template <class World>
inline constexpr bool kHasJointCoordinates = World::kMostJointCoordinates > 0;

/// A body with all that it carries, in the body's frame: the acceleration of its inboard handle is
/// Lambda F + free under the wrench F on it.
template <class World>
struct Branch {
  typename World::SymmetricTwistMatrix Lambda;
  typename World::Twist free;
};

/// The multi-port of a body, in memory of the caller's.
template <class World>
struct MultiPort {
  int handles = 1;                                           ///< count, the inboard one included
  typename World::SymmetricTwistMatrix* diagonal = nullptr;  ///< P_hh
  typename World::TwistMatrix* pairs = nullptr;  ///< P_ab, a < b: (0,1), (0,2), (1,2), (0,3), ...
  typename World::Twist* free = nullptr;         ///< accelerations without joint wrenches

  /// P_ab, rows a, columns b; a < b.
  typename World::TwistMatrix& between(int a, int b) const {
    assert(0 <= a && a < b && b < handles);
    return pairs[count_pairs(b) + a];
  }
  static constexpr int count_pairs(int handles) { return handles * (handles - 1) / 2; }
};

}  // namespace spoke::tree
