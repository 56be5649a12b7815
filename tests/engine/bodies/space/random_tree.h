#pragma once

#include <random>

#include "tests/engine/bodies/space/rigid_tree.h"

namespace spoke::space::testing {

/// Motion of a hub.
enum class HubKind { fixed, driven, torque, free };

struct RandomTree {
  int bodies = 11;
  HubKind hub = HubKind::free;
  bool is_conservative = false;  ///< no dampers, motors, loads, drives of joints
};

/// Makes a tree of all kinds of joints, several bodies with several children, in a random state.
RigidTree make_random_tree(const RandomTree& kind, std::mt19937& random);

}  // namespace spoke::space::testing
