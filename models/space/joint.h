#pragma once

// Joints of space, as constant data: a place, and a sequence of simple freedoms.

#include <array>
#include <limits>
#include <span>

#include "models/space/quaternion.h"

namespace spoke::space {

/// A stop that keeps a coordinate of a joint within bounds, smoothly. At a distance d beyond a
/// bound, the force towards it is stiffness d^2/(2 width) up to d = width, stiffness (d - width/2)
/// from there on. The damping sets in likewise: by the factor d/width up to d = width, fully from
/// there on.
struct JointStop {
  double lower = -std::numeric_limits<double>::infinity();  ///< [rad, m]
  double upper = std::numeric_limits<double>::infinity();   ///< [rad, m]
  double stiffness = 0.0;                                   ///< [N m/rad, N/m]
  double damping = 0.0;                                     ///< [N m s/rad, N s/m]
  double width = 0.0;                                       ///< [rad, m]
};

/// Friction of a coordinate with the velocity v: the force -F(v) tanh(v/speed), F(v) = force +
/// (static_force - force) exp(-(v/stribeck)^2). About rest it is a damper.
struct JointFriction {
  double force = 0.0;         ///< of sliding [N m, N]; 0: there is none
  double static_force = 0.0;  ///< at the start of sliding [N m, N], at least `force`
  double speed = 1.0;         ///< over which it sets in [rad/s, m/s]
  double stribeck = 1.0;      ///< over which it falls [rad/s, m/s]

  bool acts() const { return force > 0.0; }
  /// Returns the size of -(force)/v at v = 0 [N m s/rad, N s/m].
  double damping_at_rest() const { return static_force / speed; }
};

/// One freedom of a joint: a rotation about an axis, a displacement along one, or any rotation.
struct JointPrimitive {
  enum class Kind { revolute, prismatic, spherical };

  Kind kind = Kind::revolute;
  /// Whether its motion is prescribed, so that it has no coordinate; never so if spherical.
  bool is_driven = false;
  Position axis = Position::UnitX();  ///< unit vector in the frame after the primitives before it
  /// The frame in which a spherical primitive's velocity w_J is resolved. Where the child spins
  /// about its axis of symmetry, w_J is smooth in the parent's.
  TurnFrame frame = TurnFrame::child;
  double stiffness = 0.0;  ///< [N m/rad, N/m]; spherical: towards no rotation
  double damping = 0.0;    ///< [N m s/rad, N s/m]
  /// Coordinate at which the spring is relaxed [rad, m]; unused if spherical.
  double rest = 0.0;
  JointStop stop;          ///< stop of the coordinate; unused if spherical
  JointFriction friction;  ///< friction of the coordinate; unused if spherical

  /// Returns the number of components of its velocity.
  int components() const { return kind == Kind::spherical ? kAngular : 1; }
};

/// A joint leads from a frame on the parent to the child's frame: by a constant offset, then by its
/// primitives in their order. Their coordinates are numbered in this order; a joint without
/// primitives is rigid.
struct Joint {
  /// Most components of velocity, free and driven ones together.
  static constexpr int kMost = kTwist;

  Pose offset;  ///< pose of the joint in the frame on the parent
  std::array<JointPrimitive, kMost> primitives{};
  int primitive_count = 0;
  int coordinates = 0;    ///< n, number of free components
  int driven = 0;         ///< number of driven components
  int spherical_at = -1;  ///< first coordinate of its spherical primitive; -1: it has none
  /// Frame in which that primitive's velocity is resolved.
  TurnFrame spherical_frame = TurnFrame::child;

  std::span<const JointPrimitive> sequence() const {
    return {primitives.data(), static_cast<std::size_t>(primitive_count)};
  }
};

/// Makes a joint of at most Joint::kMost components of velocity and one spherical primitive. No
/// coordinate may be a combination of others, as a fourth rotation about one point is.
Joint make_joint(const Pose& offset, std::span<const JointPrimitive> primitives);

}  // namespace spoke::space
