#pragma once

// The motion of places that no body carries: on the hub, on the mount, on an anchor.

#include "engine/bodies/kernels/loops/loop_rows.h"
#include "engine/bodies/table/step_data.h"
#include "models/space/frame_course.h"

namespace spoke {

/// The motion of an anchor against H or A, in the axes of its description, but for its turning with
/// the hub.
struct AnchorVectors {
  space::VectorMotion translation;  ///< [m]
  space::VectorMotion rotation;     ///< rotation vector [rad]
};

/// Returns the motion of an anchor at time t [s].
AnchorVectors follow(const AnchorModel& anchor, double t);

/// The motion of the frame A in which the axle turns, as H sees it: A is H at the angle 0. What
/// stands still where the hub has no axle.
struct MountFrame {
  space::Rotation R;                                 ///< from A to H
  space::Twist twist = space::Twist::Zero();         ///< of its origin, inertial, in H [m/s, rad/s]
  space::Twist acceleration = space::Twist::Zero();  ///< likewise, less gravity [m/s^2, rad/s^2]
  double spin = 0.0;                                 ///< rate of the hub's angle, in A [rad/s]
};

/// The motion of a place that no body carries, with its acceleration as far as it does not depend
/// on the hub's, less gravity, in H.
struct CarriedPlace {
  PlaceMotion motion;
  space::Twist acceleration = space::Twist::Zero();  ///< [m/s^2, rad/s^2]
  bool is_on_hub = false;                            ///< the hub carries it; else the mount
  /// Of a place that an anchor moves against a body: its own motion against that, in H.
  space::Twist own = space::Twist::Zero();  ///< [m/s, rad/s]
  /// Of an anchor of the mount or the axle that turns with the hub: unit vector of the axis about
  /// which it does, in H; else zero.
  space::Angular pivot = space::Angular::Zero();
  space::Position pivot_place = space::Position::Zero();  ///< a point of that axis, in H [m]
  double mount_spin_up = 0.0;  ///< angular acceleration of the mount about the axle [rad/s^2]
};

/// Returns the motion of the hub, as vectors of space: place, rotation and twist.
HubState<Space> hub_in_space(const HubState<Plane>& hub);
inline const HubState<Space>& hub_in_space(const HubState<Space>& hub) { return hub; }

/// Calculates the mount at time t [s]. The hub's motion must be that of the pass.
MountFrame calc_mount_frame(const System<Plane>& system, const HubState<Plane>& hub, double t);
MountFrame calc_mount_frame(const System<Space>& system, const HubState<Space>& hub, double t);

/// Calculates a place that an anchor moves against a body at time t [s], by the handle's place and
/// rotation to H, and its twist in H. Its acceleration is that at zero of the handle.
CarriedPlace calc_moved_place(const AnchorModel& anchor, const LoopPlaceModel& place,
                              const space::Pose& handle, const space::Twist& twist,
                              double t) noexcept;
/// Calculates a place on the hub, the mount or an anchor at time t [s]. `axle`: of a hub on a
/// support, its turn about the axle, which the drive prescribes where an anchor stands beside it.
template <class World>
CarriedPlace calc_carried_place(const System<World>& system, const HubState<World>& hub,
                                const DriveMotion* axle, const LoopPlaceModel& place,
                                double t) noexcept;

}  // namespace spoke
