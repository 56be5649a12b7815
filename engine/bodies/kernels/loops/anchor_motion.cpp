// Calculates the mount and what it or the hub carries.

#include "engine/bodies/kernels/loops/anchor_motion.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include "models/space/mount.h"

namespace spoke {
namespace space {
namespace {

VectorMotion follow_said(const SaidAnchorMotion& said, double t, int first) {
  const double s = t - said.since;
  const auto part = [first](const Twist& twist) { return Position(twist.segment<3>(first)); };
  return {part(said.value) + s * (part(said.rate) + 0.5 * s * part(said.acceleration)),
          part(said.rate) + s * part(said.acceleration), part(said.acceleration)};
}

/// Returns the motion of an anchor in H or A, in their axes, but for its turning with the hub.
FrameCourse calc_anchor_course(const AnchorModel& anchor, double t) {
  AnchorVectors course = spoke::follow(anchor, t);
  for (VectorMotion* motion : {&course.translation, &course.rotation})
    *motion = {anchor.to_axis * motion->value, anchor.to_axis * motion->rate,
               anchor.to_axis * motion->acceleration};
  return make_frame_course(course.translation, course.rotation);
}

/// Returns a point at `offset` of a frame that moves by `course`, and its own frame.
FrameCourse move_on(const FrameCourse& course, const Pose& offset) {
  const Position r = course.R * offset.p;
  FrameCourse moved = course;
  moved.p += r;
  moved.v += cross(course.w, r);
  moved.a += cross(course.alpha, r) + cross(course.w, cross(course.w, r));
  moved.R = course.R * offset.R;
  return moved;
}

/// Turns a frame about its z axis by the hub's angle, as `turn` does, at the rate `spin`, which
/// does not change.
FrameCourse turn_with_hub(const FrameCourse& course, const Rotation& turn, double spin) {
  const Position axis = course.R * Position(Position::UnitZ());
  FrameCourse spun = course;
  spun.R = course.R * turn;
  spun.w += spin * axis;
  spun.alpha += spin * cross(course.w, axis);
  return spun;
}

/// The motion of a frame that carries others: its rotation to H, its twist and acceleration there.
struct Carrier {
  Rotation R;
  Position p;  ///< of its origin, in H
  Twist twist, acceleration;
};

void carry(const Carrier& carrier, const FrameCourse& course, CarriedPlace& place) {
  const Position r = carrier.R * course.p, v = carrier.R * course.v;
  const Angular w = angular(carrier.twist), w_own = carrier.R * course.w;
  const Angular alpha = angular(carrier.acceleration);
  place.motion.p = carrier.p + r;
  place.motion.R = carrier.R * course.R;
  place.motion.twist = make_twist(Position(linear(carrier.twist)) + cross(w, r) + v, w + w_own);
  place.acceleration =
      make_twist(Position(linear(carrier.acceleration)) + cross(alpha, r) + cross(w, cross(w, r)) +
                     2.0 * cross(w, v) + carrier.R * course.a,
                 alpha + cross(w, w_own) + carrier.R * course.alpha);
}

/// Calculates a place on the mount: the anchor's, or one that is fixed to it.
CarriedPlace calc_on_mount(const MountFrame& mount, const AnchorModel* anchor,
                           const LoopPlaceModel& model, double t) {
  CarriedPlace place;
  FrameCourse course = anchor ? calc_anchor_course(*anchor, t) : FrameCourse{};
  if (anchor && anchor->turns_with_hub) {
    place.pivot = mount.R * Position(course.R * Position(Position::UnitZ()));
    place.pivot_place = mount.R * course.p;
    place.mount_spin_up = mount.acceleration[Space::kAxial];
    course = turn_with_hub(course, mount.R.inverse(), mount.spin);
  }
  carry({mount.R, Position::Zero(), mount.twist, mount.acceleration}, move_on(course, model.offset),
        place);
  return place;
}

/// Calculates a place on an anchor beside the axle, which turns as the drive prescribes: then it is
/// one on the hub that turns back.
CarriedPlace calc_beside_axle(const Twist& hub, const DriveMotion& axle, const AnchorModel& anchor,
                              const LoopPlaceModel& model, double t) {
  const Angular n = Angular::UnitZ();
  const Rotation back = exponential(Angular(-axle.angle * n));
  CarriedPlace place;
  FrameCourse course = calc_anchor_course(anchor, t);
  if (anchor.turns_with_hub) {
    const Position plate = course.R * Position(Position::UnitZ());
    place.pivot = back * plate;
    place.pivot_place = back * course.p;
    course = turn_with_hub(course, back.inverse(), axle.speed);
    course.alpha += axle.acceleration * plate;
  }
  Carrier standing{back, Position::Zero(), hub, Twist::Zero()};
  angular(standing.twist) -= axle.speed * n;
  angular(standing.acceleration) =
      -axle.acceleration * n - axle.speed * cross(Angular(angular(hub)), n);
  place.is_on_hub = true;
  carry(standing, move_on(course, model.offset), place);
  return place;
}

}  // namespace
}  // namespace space

AnchorVectors follow(const AnchorModel& anchor, double t) {
  if (const auto* motion = std::get_if<spatial::MountMotion>(&anchor.motion))
    return {space::follow(motion->translation, t), space::follow(motion->rotation, t)};
  const auto& said = std::get<SaidAnchorMotion>(anchor.motion);
  return {space::follow_said(said, t, 0), space::follow_said(said, t, space::kRotation)};
}

HubState<Space> hub_in_space(const HubState<Plane>& hub) {
  const space::Rotation R =
      space::exponential(space::Angular(0.0, 0.0, std::atan2(hub.R.sine, hub.R.cosine)));
  return {space::Position(hub.p.x(), hub.p.y(), 0.0), R,
          space::make_twist(space::Position(hub.twist[0], hub.twist[1], 0.0),
                            space::Angular(0.0, 0.0, hub.twist[2]))};
}

MountFrame calc_mount_frame(const System<Plane>& system, const HubState<Plane>& hub, double t) {
  MountFrame mount;
  mount.R = hub_in_space(hub).R.inverse();
  mount.spin = hub.twist[kRotation];
  const space::Position g =
      mount.R * space::Position(system.gravity_at(t).x(), system.gravity_at(t).y(), 0.0);
  linear(mount.acceleration) = -g;
  return mount;
}

MountFrame calc_mount_frame(const System<Space>& system, const HubState<Space>& hub, double t) {
  const space::AxleMotion axle = calc_axle_motion(system.hub, t);
  const space::Rotation back = hub.R.inverse();
  MountFrame mount;
  mount.R = back * axle.R;
  mount.twist = space::make_twist(back * axle.v, mount.R * axle.w);
  mount.acceleration = space::make_twist(
      back * space::Position(axle.a - space::Position(system.gravity_at(t))), mount.R * axle.alpha);
  mount.spin = hub.twist[Space::kAxial] - axle.w.z();
  return mount;
}

CarriedPlace calc_moved_place(const AnchorModel& anchor, const LoopPlaceModel& model,
                              const space::Pose& handle, const space::Twist& twist,
                              double t) noexcept {
  assert(model.is_moved());
  const space::FrameCourse course =
      space::move_on(space::calc_anchor_course(anchor, t), model.offset);
  const space::Rotation R = handle.R * model.base.R;
  CarriedPlace place;
  space::carry({R, handle.p, twist, space::Twist::Zero()}, course, place);
  place.own = space::make_twist(R * course.v, R * course.w);
  return place;
}

template <class World>
CarriedPlace calc_carried_place(const System<World>& system, const HubState<World>& hub,
                                const DriveMotion* axle, const LoopPlaceModel& place,
                                double t) noexcept {
  assert(place.carrier != LoopPlace::Carrier::body);
  const AnchorModel* anchor = nullptr;
  if (place.carrier == LoopPlace::Carrier::anchor)
    anchor = &system.anchors[static_cast<std::size_t>(place.anchor)];
  const bool is_on_mount = place.carrier == LoopPlace::Carrier::mount ||
                           (anchor && anchor->frame == Anchor::Frame::mount);
  if (is_on_mount) return space::calc_on_mount(calc_mount_frame(system, hub, t), anchor, place, t);
  if (anchor && anchor->frame == Anchor::Frame::axle) {
    assert(axle);
    return space::calc_beside_axle(hub_in_space(hub).twist, *axle, *anchor, place, t);
  }
  CarriedPlace carried;
  carried.is_on_hub = true;
  const space::FrameCourse course =
      anchor ? space::calc_anchor_course(*anchor, t) : space::FrameCourse{};
  space::carry({{}, space::Position::Zero(), hub_in_space(hub).twist, space::Twist::Zero()},
               space::move_on(course, place.offset), carried);
  return carried;
}

template CarriedPlace calc_carried_place(const System<Plane>&, const HubState<Plane>&,
                                         const DriveMotion*, const LoopPlaceModel&,
                                         double) noexcept;
template CarriedPlace calc_carried_place(const System<Space>&, const HubState<Space>&,
                                         const DriveMotion*, const LoopPlaceModel&,
                                         double) noexcept;

}  // namespace spoke
