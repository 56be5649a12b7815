#pragma once

// What is simulated, as constant data: a hub and its subsystems (blades), each a chain of flexible
// bodies tied by bracket joints, the first tied to the hub.

#include <memory>
#include <vector>

#include "models/rotor.h"
#include "models/system/blade_loads.h"
#include "models/system/flexible_body.h"
#include "models/system/space.h"

namespace spoke {

/// A body in its chain.
struct ChainBody {
  std::shared_ptr<const FlexibleBody> body;
  /// KG of make_centrifugal_stiffness; null if the blade has no geometric stiffening.
  std::shared_ptr<const SymmetricBand<3>> centrifugal_stiffness;
  /// make_slope_integral, for the tip's displacement; null likewise.
  std::shared_ptr<const SymmetricBand<3>> slope_integral;
  std::vector<BodyLoad> loads;
  std::vector<BodyDrag> drags;
};

/// A chain of bodies, root to tip.
struct Subsystem {
  Pose root;            ///< pose of the root bracket in the hub frame
  double length = 0.0;  ///< undeformed, root to tip [m]
  std::vector<ChainBody> bodies;
};

struct System {
  Hub hub;
  std::vector<HubLoad> hub_loads;
  std::vector<Subsystem> subsystems;
  Position gravity = Position::Zero();  ///< inertial frame, at full size [m/s^2]
  double gravity_ramp = 0.0;            ///< [s]
  Damping damping;

  /// In force at time t [s].
  Position gravity_at(double t) const { return gravity * calc_rise(t, gravity_ramp); }

  int body_count() const;
  /// Deformation coordinates of all bodies together.
  int deformation_count() const;
};

/// Whether component `c` of the hub's twist (x, y, rotation) is prescribed.
bool is_prescribed(const Hub& hub, int c);

/// Builds the constants of a rotor; equal bodies share them.
System make_system(const Rotor& rotor);

}  // namespace spoke
