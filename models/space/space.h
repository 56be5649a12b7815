#pragma once

// The world of space: sizes and types for algorithms that are written once for plane and space (see
// models/plane/plane.h). The functions on these types have the names of the plane's
// (models/plane/plane.h) and are found by their arguments.

#include <optional>

#include "models/space/quaternion.h"
#include "models/space/rotation.h"
#include "models/space/rotation_vector.h"
#include "models/space/symmetric_twist_matrix.h"
#include "models/space/vectors.h"

namespace spoke {

namespace space {
struct Body;
struct Hub;
struct HubLoad;
struct TensionPlace;
struct TreeJoint;
}  // namespace space

/// Space, as a `World`: its sizes and types.
struct Space {
  static constexpr int kPosition = space::kPosition;
  static constexpr int kAngular = space::kAngular;
  static constexpr int kTwist = space::kTwist;
  static constexpr int kRotation = space::kRotation;  ///< the first rotational component
  /// Component of a twist about z: the axis of an axle.
  static constexpr int kAxial = kTwist - 1;
  /// Coordinates that a joint may have; those of the plane are rigid.
  static constexpr int kMostJointCoordinates = kTwist;

  using Position = space::Position;
  using Angular = space::Angular;
  using Twist = space::Twist;
  using TwistMatrix = space::TwistMatrix;
  using Rotation = space::Rotation;
  using SymmetricTwistMatrix = space::SymmetricTwistMatrix;
  using Pose = space::Pose;

  using Hub = space::Hub;
  using HubLoad = space::HubLoad;
  using Body = space::Body;
  using Joint = space::TreeJoint;
  using Stiffening = std::optional<space::TensionPlace>;
};

}  // namespace spoke
