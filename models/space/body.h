#pragma once

// A body of a tree in space: flexible or rigid.

#include <memory>
#include <variant>

#include "models/space/flexible_body.h"
#include "models/space/rigid_body.h"

namespace spoke::space {

/// Handle 0 is the inboard one, at the origin of the body's frame; at each other one hangs a child.
struct Body {
  std::variant<FlexibleBody, RigidBody> shape;
  std::shared_ptr<const Beam> beam;  ///< that a flexible one is a part of

  /// Null if it is rigid.
  const FlexibleBody* flexible() const { return std::get_if<FlexibleBody>(&shape); }
  /// Null if it is flexible.
  const RigidBody* rigid() const { return std::get_if<RigidBody>(&shape); }

  int handle_count() const {
    if (const FlexibleBody* body = flexible()) return static_cast<int>(body->handles.size());
    return 1 + static_cast<int>(rigid()->outboard.size());
  }
  /// Deformation coordinates.
  int coordinates() const { return flexible() ? flexible()->coordinates() : 0; }
  /// Of its axis, by which limits of its deformation are measured [m]; of a rigid one infinite.
  double extent() const;
};

}  // namespace spoke::space
