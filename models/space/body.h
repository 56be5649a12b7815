#pragma once

// A body of a tree in space: flexible or rigid.

#include <memory>
#include <variant>

#include "models/space/flexible_body.h"
#include "models/space/rigid_body.h"

namespace spoke::space {

/// A body. Handle 0 is the inboard one, at the origin of the body's frame; a child hangs at each
/// other one, but for those behind them, at which loops are fixed.
struct Body {
  std::variant<FlexibleBody, RigidBody> shape;
  std::shared_ptr<const Beam> beam;  ///< the beam that a flexible body is a part of

  /// Returns the flexible body; null if it is rigid.
  const FlexibleBody* flexible() const { return std::get_if<FlexibleBody>(&shape); }
  /// Returns the rigid body; null if it is flexible.
  const RigidBody* rigid() const { return std::get_if<RigidBody>(&shape); }

  int handle_count() const {
    if (const FlexibleBody* body = flexible()) return static_cast<int>(body->handles.size());
    return 1 + static_cast<int>(rigid()->outboard.size());
  }
  /// Returns the number of deformation coordinates.
  int coordinates() const { return flexible() ? flexible()->coordinates() : 0; }
  /// Returns the length of its axis, by which limits of its deformation are measured [m]; infinite
  /// for a rigid body.
  double extent() const;
};

}  // namespace spoke::space
