#pragma once

// The hub of a system in space, and the loads on it.

#include <cassert>
#include <optional>

#include "models/curve.h"
#include "models/drive.h"
#include "models/rotor.h"
#include "models/space/space.h"
#include "models/spatial_model.h"

namespace spoke::space {

/// A hub. Its frame H has the axis of the drive as z axis, and the hub's origin as origin.
struct Hub {
  HubSupport support = HubSupport::axle;
  Drive drive = FreeDrive{};
  Quaternion orientation;        ///< orientation of H in the inertial frame at angle 0, or at t = 0
  SymmetricTwistMatrix inertia;  ///< M_0 = [m 1, -S~; S~, Theta], about the origin, in H
  double mass = 0.0;             ///< [kg]
  /// The motion of the axle's mount; none: at rest.
  std::optional<spatial::MountMotion> mount = std::nullopt;
  Position position = Position::Zero();  ///< place of a free hub at t = 0, inertial frame [m]
  /// Velocity of a free hub at t = 0: translation in the inertial frame, rotation in H.
  Twist velocity = Twist::Zero();
};

/// A force at a point that is fixed to the hub, and a moment, scaled by a function of time.
struct HubLoad {
  Position position = Position::Zero();  ///< place of the point in H [m]
  /// Frame in which force and moment are resolved: hub (H) or inertial.
  LoadFrame frame = LoadFrame::hub;
  Position force = Position::Zero();  ///< [N]
  Angular moment = Angular::Zero();   ///< moment besides that of the force [N m]
  double ramp = 0.0;                  ///< duration of the smooth rise, calc_rise() [s]
  Curve factor{1.0};
};

/// Whether component `c` of the hub's twist (x, y, z, and about them) is prescribed: on an axle all
/// but the rotation about z are, and that by a drive that prescribes motion.
inline bool is_prescribed(const Hub& hub, int c) {
  assert(c >= 0 && c < kTwist);
  return c == kTwist - 1 ? prescribes_motion(hub.drive) : hub.support == HubSupport::axle;
}

/// Returns the rotation from H to the inertial frame at an angle of the drive [rad], without the
/// mount's motion.
inline Rotation rotation_of(const Hub& hub, double angle) {
  return make_rotation(hub.orientation) * exponential(Angular(0.0, 0.0, angle));
}
inline Angular moment_of(const HubLoad& load) { return load.moment; }
inline TwistMatrix calc_hub_mass(const Hub& hub) { return hub.inertia.matrix(); }
/// Returns the moment of inertia of the hub alone about its axis [kg m^2].
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
