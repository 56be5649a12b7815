#pragma once

// A rigid body in which something spins, as a kind: a reaction wheel, a flywheel, a propeller that
// a motor keeps at its momentum h relative to the body. The mass of what spins is the body's.

#include "engine/bodies/kinds/rigid/rigid_kind.h"

namespace spoke {

class GyrostatKind final : public RigidKind {
 public:
  /// Adds the gyroscopic moment -w x h to the terms of a rigid body.
  void calc_terms(const System<Space>& system, double t, const space::ImplicitShares& shares,
                  std::size_t j, SubsystemData<Space>& data) const noexcept override;
  space::Twist calc_momentum(const Data& body, const space::Twist& twist) const noexcept override;
  const char* name() const noexcept override { return "rigid body with a spin"; }
};

}  // namespace spoke
