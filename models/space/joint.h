#pragma once

// Joints of space, as constant data: a place, and a sequence of simple freedoms.

#include <array>
#include <limits>
#include <span>

#include "models/space/quaternion.h"

namespace spoke::space {

/// What keeps a coordinate of a joint within bounds, smoothly. A distance d beyond a bound, the
/// force towards it is stiffness d^2/(2 width) up to d = width, stiffness (d - width/2) from there
/// on. The damper acts as the stiffness does, in the share d/width up to d = width, then whole.
struct JointStop {
  double lower = -std::numeric_limits<double>::infinity();  ///< [rad, m]
  double upper = std::numeric_limits<double>::infinity();   ///< [rad, m]
  double stiffness = 0.0;                                   ///< [N m/rad, N/m]
  double damping = 0.0;                                     ///< [N m s/rad, N s/m]
  double width = 0.0;                                       ///< [rad, m]
};

/// One freedom of a joint: a rotation about an axis, a displacement along one, or any rotation.
struct JointPrimitive {
  enum class Kind { revolute, prismatic, spherical };

  Kind kind = Kind::revolute;
  /// Its motion is prescribed, and it has no coordinate; not of a spherical one.
  bool is_driven = false;
  Position axis = Position::UnitX();  ///< unit vector, in the frame that those before have reached
  /// Of a spherical one, in which frame its velocity w_J is resolved. Where the child spins about
  /// its axis of symmetry, w_J is smooth in the parent's.
  TurnFrame frame = TurnFrame::child;
  double stiffness = 0.0;  ///< [N m/rad, N/m]; of a spherical one, towards no rotation
  double damping = 0.0;    ///< [N m s/rad, N s/m]
  double rest = 0.0;       ///< coordinate at which the spring is relaxed [rad, m]; not spherical
  JointStop stop;          ///< not of a spherical one

  /// Components of its velocity.
  int components() const { return kind == Kind::spherical ? kAngular : 1; }
};

/// A joint leads from a frame on the parent to the child's frame: by a constant offset, then by its
/// primitives in their order. Their coordinates are numbered in this order; a joint without is
/// rigid.
struct Joint {
  /// Components of velocity, free and driven ones together.
  static constexpr int kMost = kTwist;

  Pose offset;  ///< in the frame on the parent
  std::array<JointPrimitive, kMost> primitives{};
  int primitive_count = 0;
  int coordinates = 0;    ///< n, components that are free
  int driven = 0;         ///< components that are driven
  int spherical_at = -1;  ///< first coordinate of its spherical primitive; -1: there is none
  TurnFrame spherical_frame = TurnFrame::child;  ///< in which the primitive's velocity is resolved

  std::span<const JointPrimitive> sequence() const {
    return {primitives.data(), static_cast<std::size_t>(primitive_count)};
  }
};

/// A joint of at most Joint::kMost components of velocity and one spherical primitive. No
/// coordinate may be a combination of others, as a fourth rotation about one point is.
Joint make_joint(const Pose& offset, std::span<const JointPrimitive> primitives);

}  // namespace spoke::space
