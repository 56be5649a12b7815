#pragma once

// A block of coordinates among which is an orientation (see engine/step/integrator/rotation.h).

#include "engine/bodies/coordinate_block.h"
#include "models/space/quaternion.h"

namespace spoke::space {

/// State of an orientation besides its block.
struct RotationState {
  Quaternion reference;                   ///< Q_n
  Quaternion sum{0.0, Position::Zero()};  ///< weighted rates of the stages, for rk4
};

/// A block of coordinates among which is an orientation: at `at`, `at + 1`, `at + 2` stand D in q,
/// w in v, w' in a.
struct RotationBlock {
  CoordinateBlock* block = nullptr;
  int at = 0;
  RotationState* state = nullptr;
  TurnFrame frame = TurnFrame::child;
};

}  // namespace spoke::space
