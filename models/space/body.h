#pragma once

// A body of a tree in space: a part of a beam, rigid, or a solid.

#include <memory>
#include <variant>

#include "models/space/flexible_body.h"
#include "models/space/rigid_body.h"
#include "models/space/solid.h"

namespace spoke::space {

/// A body. Handle 0 is the inboard one, at the origin of the body's frame; a child hangs at each
/// other one, but for those behind them, at which loops are fixed.
struct Body {
  std::variant<FlexibleBody, RigidBody, Solid> shape;
  std::shared_ptr<const Beam> beam;  ///< the beam that a FlexibleBody is a part of

  /// Returns the part of a beam; null if it is none.
  const FlexibleBody* flexible() const { return std::get_if<FlexibleBody>(&shape); }
  /// Returns the rigid body; null if it is none.
  const RigidBody* rigid() const { return std::get_if<RigidBody>(&shape); }
  /// Returns the solid; null if it is none.
  const Solid* solid() const { return std::get_if<Solid>(&shape); }

  double mass() const;  ///< [kg]
  int handle_count() const;
  /// Returns the place of a handle at rest in the body's frame [m].
  Position handle_at_rest(std::size_t handle) const;
  /// Returns the number of deformation coordinates.
  int coordinates() const;
  /// Whether its inboard handle may move away from the origin of its frame.
  bool moves_inboard() const {
    return solid() && solid()->constants->frame == spatial::SolidFrame::mean_axis;
  }
  /// Returns the length of its axis, or the greatest distance of a node of a solid from its frame,
  /// by which limits of its deformation are measured [m]; infinite for a rigid body.
  double extent() const;
  /// Returns a value that all coordinates may have [m, rad, sqrt(kg) m]: its extent, or pi if that
  /// is less.
  double coordinate_limit() const;
};

}  // namespace spoke::space
