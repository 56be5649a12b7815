#pragma once

// The world of space: what algorithms that are written once for plane and space take their sizes
// and types from. The functions on these types have the names of the plane's
// (models/system/plane.h) and are found by their arguments.

#include "models/space/quaternion.h"
#include "models/space/rotation.h"
#include "models/space/rotation_vector.h"
#include "models/space/symmetric_twist_matrix.h"
#include "models/space/vectors.h"

namespace spoke {

struct Space {
  static constexpr int kPosition = space::kPosition;
  static constexpr int kAngular = space::kAngular;
  static constexpr int kTwist = space::kTwist;
  static constexpr int kRotation = space::kRotation;  ///< the first rotational component
  /// Coordinates that a joint may have; those of the plane are rigid.
  static constexpr int kMostJointCoordinates = kTwist;

  using Position = space::Position;
  using Angular = space::Angular;
  using Twist = space::Twist;
  using TwistMatrix = space::TwistMatrix;
  using Rotation = space::Rotation;
  using SymmetricTwistMatrix = space::SymmetricTwistMatrix;
  using Pose = space::Pose;
};

}  // namespace spoke
