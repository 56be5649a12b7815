#pragma once

// A body as pictures show it.

#include <vector>

#include "engine/bodies/space/handle_motion.h"

namespace spoke::space {

/// A node of a body as pictures show it.
struct ShapeNode {
  Rotation frame;                           ///< from the axes of the body to those of the scenario
  Position place = Position::Zero();        ///< at rest, in B [m]
  HandleMotion motion;                      ///< against the body
  Position inward = Position::Zero();       ///< foreshortening of its place, in B [m]
  Position inward_rate = Position::Zero();  ///< [m/s]
};

/// The nodes of a body, and of a beam by element the load in its middle, in its axes [N, N m].
struct BodyShape {
  std::vector<ShapeNode> nodes;
  std::vector<Twist> forces;
};

}  // namespace spoke::space
