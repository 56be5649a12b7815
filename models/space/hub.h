#pragma once

// The hub of a system in space, and what acts on it.

#include <optional>

#include "models/curve.h"
#include "models/drive.h"
#include "models/rotor.h"
#include "models/space/space.h"
#include "models/spatial_model.h"

namespace spoke::space {

/// Its frame H has the axis of the drive as z axis, and the hub's origin as origin.
struct Hub {
  HubSupport support = HubSupport::axle;
  Drive drive = FreeDrive{};
  Quaternion orientation;        ///< of H in the inertial frame at angle 0, or at t = 0
  SymmetricTwistMatrix inertia;  ///< M_0 = [m 1, -S~; S~, Theta], about the origin, in H
  double mass = 0.0;             ///< [kg]
  /// How what holds the axle moves; none: at rest.
  std::optional<spatial::MountMotion> mount = std::nullopt;
  Twist velocity = Twist::Zero();  ///< of a free hub at t = 0: inertial frame; rotation in H
};

/// A force at a point that is fixed to the hub, and a moment, scaled by a function of time.
struct HubLoad {
  Position position = Position::Zero();  ///< in H [m]
  LoadFrame frame = LoadFrame::hub;      ///< in which both are resolved: hub (H) or inertial
  Position force = Position::Zero();     ///< [N]
  Angular moment = Angular::Zero();      ///< besides that of the force [N m]
  double ramp = 0.0;                     ///< see calc_rise() [s]
  Curve factor{1.0};
};

/// Whether component `c` of the hub's twist (x, y, z, and about them) is prescribed: on an axle all
/// but the rotation about z are, and that by a drive that prescribes motion.
inline bool is_prescribed(const Hub& hub, int c) {
  return c == kTwist - 1 ? prescribes_motion(hub.drive) : hub.support == HubSupport::axle;
}

/// H to the inertial frame, at an angle of the drive [rad], where the mount has not moved.
inline Rotation rotation_of(const Hub& hub, double angle) {
  return make_rotation(hub.orientation) * exponential(Angular(0.0, 0.0, angle));
}
inline Angular moment_of(const HubLoad& load) { return load.moment; }
inline TwistMatrix calc_hub_mass(const Hub& hub) { return hub.inertia.matrix(); }
/// Of the hub alone, about its axis [kg m^2].
inline double axial_inertia(const Hub& hub) { return hub.inertia.rr()(2, 2); }
/// Adds the forces of the hub's own inertia at zero acceleration.
inline void add_gyroscopic_force(const Hub& hub, const Twist& twist, Twist& force) {
  const Angular w = angular(twist);
  const Matrix3 rt = hub.inertia.rt();
  const Position S(rt(2, 1), rt(0, 2), rt(1, 0));
  linear(force) -= cross(w, cross(w, S));
  angular(force) -= cross(w, Position(hub.inertia.rr().lazyProduct(w)));
}

}  // namespace spoke::space
