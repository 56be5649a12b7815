// Carries accelerations from the hub outward along a path of bodies.

#include "engine/bodies/kernels/space/relative_motion.h"

#include <cassert>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/table/body_kind.h"

namespace spoke {
namespace {

using space::Angular;
using space::HandleMotion;
using space::Position;
using space::Rotation;

/// Returns the acceleration of the handle that carries a body, or of the hub, in the parent's
/// frame: J (X; q'') + b.
space::Twist carrier_acceleration(const TreeBody<Space>& body, const SubsystemData<Space>& data,
                                  const space::Twist& parent_X) {
  if (body.parent < 0) return parent_X;
  const auto p = static_cast<std::size_t>(body.parent);
  return calc_handle_acceleration(data, p, body.handle, parent_X);
}

/// Calls `visit(j, X)` for the bodies of a path, from the hub.
template <class Visit>
void walk(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
          const space::Twist& hub_acceleration, const std::vector<int>& path, Visit&& visit) {
  space::Twist X = hub_acceleration;
  for (const int body : path) {
    const auto j = static_cast<std::size_t>(body);
    X = calc_next_acceleration(subsystem.bodies[j], j, data, X);
    visit(j, X);
  }
}

/// Observes from the hub: turns motions by a velocity and an acceleration in H into those relative
/// to it.
struct Observer {
  space::Twist twist, acceleration;

  void observe(const space::Twist& velocity, const space::Twist& found, SpatialMotion& m) const {
    const Angular w0 = angular(twist), alpha0 = angular(acceleration);
    m.v = Position(linear(velocity)) - Position(linear(twist)) - cross(w0, m.p);
    m.w = Angular(angular(velocity)) - w0;
    m.a = Position(linear(found)) - Position(linear(acceleration)) - cross(alpha0, m.p) -
          centripetal(w0, m.p) - 2.0 * cross(w0, m.v);
    m.alpha = Angular(angular(found)) - alpha0 - cross(w0, m.w);
  }
};

/// Motion of a frame or a section of a body: its place, orientation, velocity and acceleration, in
/// B.
struct InBody {
  Position s = Position::Zero();
  Rotation R;
  space::Twist velocity, acceleration;
};

InBody section_in_body(const BodyData<Space>& body, const space::Section& section,
                       const space::Twist& twist, const space::Twist& X) {
  const HandleMotion motion = motion_at(body, section);
  return {motion.s, motion.turn.R * section.axes, motion.carry(twist) + motion.twist(),
          body.kind->calc_section_acceleration(body, section, motion, X, angular(twist),
                                               body.coordinates.a)};
}

SpatialMotion observe(const Observer& hub, const space::Pose& X_HB, const InBody& in_body) {
  SpatialMotion m;
  m.p = X_HB.p + X_HB.R * in_body.s;
  m.R = X_HB.R * in_body.R;
  hub.observe(X_HB.R * in_body.velocity, X_HB.R * in_body.acceleration, m);
  return m;
}

}  // namespace

// R^T (T a + H q_J'' + bias) of the joint, less (u'', H th'') + b of its own inboard handle.
space::Twist calc_next_acceleration(const TreeBody<Space>& body, std::size_t j,
                                    const SubsystemData<Space>& data,
                                    const space::Twist& parent_X) noexcept {
  const space::JointMotion& joint = data.joints[j];
  const BodyData<Space>& own = data.bodies[j];
  // This is the acceleration of its inboard section, which moves against a chord frame.
  space::Twist X = calc_carried_acceleration(joint, carrier_acceleration(body, data, parent_X));
  space::Twist by_coordinates = space::Twist::Zero();
  for (int c = 0; c < body.joint.joint.coordinates; ++c)
    by_coordinates += own.joint.coordinates.a[c] * joint.columns.col(c);
  X += joint.R.inverse() * by_coordinates;
  return X - own.kind->calc_handle_deformation(own, 0) -
         own.work.handles[0].bias(angular(data.twists[j]));
}

space::Twist calc_handle_acceleration(const SubsystemData<Space>& data, std::size_t j, int handle,
                                      const space::Twist& X) noexcept {
  const BodyData<Space>& body = data.bodies[j];
  assert(handle >= 0 && handle < body.work.port.handles);
  const HandleMotion& motion = body.work.handles[handle];
  return motion.carry(X) + body.kind->calc_handle_deformation(body, handle) +
         motion.bias(angular(data.twists[j]));
}

space::Twist calc_hub_acceleration(const System<Space>& system, std::size_t i,
                                   const StepData<Space>& data, double t) noexcept {
  assert(i < data.subsystems.size());
  if (!data.is_coupled) return data.subsystems[i].prescribed.acceleration;
  if (const int rotor = data.subsystems[i].rotor; rotor >= 0)
    return data.rotors[static_cast<std::size_t>(rotor)].acceleration;
  const double* a = data.hub_coordinates.a;
  const space::Position less_gravity =
      space::Position(a[0], a[1], a[2]) - space::Position(system.gravity_at(t));
  return space::make_twist(data.hub.R.inverse() * less_gravity,
                           space::Angular(a[3], a[4], a[5] + calc_carried_spin_up(system, t)));
}

space::Twist calc_frame_acceleration(const Subsystem<Space>& subsystem,
                                     const SubsystemData<Space>& data,
                                     const space::Twist& hub_acceleration,
                                     const std::vector<int>& path) noexcept {
  space::Twist last = hub_acceleration;
  walk(subsystem, data, hub_acceleration, path,
       [&last](std::size_t, const space::Twist& X) { last = X; });
  return last;
}

SpatialMotion calc_shown_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                                const space::Twist& hub_acceleration,
                                const Reading<Space>& reading) noexcept {
  assert(!reading.path.empty());
  const Observer hub{data.hub->twist, hub_acceleration};
  SpatialMotion shown;
  SpatialMotion short_of;  // foreshortening, with the other sign
  std::size_t passed = 0;
  const auto add = [&](std::size_t j, const space::Twist& X) {
    const BodyData<Space>& body = data.bodies[j];
    const std::size_t next = ++passed;
    const bool is_last = static_cast<int>(j) == reading.body();
    if (is_last)
      shown =
          observe(hub, data.poses[j], section_in_body(body, reading.section, data.twists[j], X));
    if (!body.model->stiffening) return;
    const SpatialMotion frame =
        observe(hub, data.poses[j], {space::Position::Zero(), {}, data.twists[j], X});
    if (is_last) return body.kind->add_shown_drawn(body, reading.section, frame, short_of);
    const auto outer = static_cast<std::size_t>(reading.path[next]);
    body.kind->add_shown_drawn(body, subsystem.bodies[outer].handle, frame, short_of);
  };
  if (is_accelerated(reading))
    walk(subsystem, data, hub_acceleration, reading.path, add);
  else
    for (const int j : reading.path) add(static_cast<std::size_t>(j), space::Twist::Zero());
  shown.p += short_of.p;
  shown.v += short_of.v;
  shown.a += short_of.a;
  return shown;
}

}  // namespace spoke
