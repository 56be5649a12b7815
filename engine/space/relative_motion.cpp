// Carries accelerations from the hub outward along a path of bodies.

#include "engine/space/relative_motion.h"

#include <cassert>

#include "engine/kernels/hub_motion.h"
#include "engine/space/body_energies.h"
#include "engine/space/solid_places.h"
#include "engine/space/solid_table_terms.h"
#include "engine/space/table_terms.h"

namespace spoke {
namespace {

using space::Angular;
using space::HandleMotion;
using space::Position;
using space::Rotation;

/// Returns the share of a body's deformation in the acceleration of a handle: (u'', H th'').
space::Twist deform(const BodyData<Space>& body, int handle) {
  assert(handle >= 0 && handle < body.work.port.handles);
  space::Twist acceleration = space::Twist::Zero();
  if (const space::Solid* solid = body.model->body->solid())
    return calc_place_deformation(solid->handle(static_cast<std::size_t>(handle)),
                                  body.work.handles[handle], body.coordinates.a);
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (!flexible) return acceleration;
  const int node = flexible->handles[static_cast<std::size_t>(handle)];
  for (int c = 0; c < space::kTwist; ++c)
    if (const int at = flexible->coordinate(node, c); at >= 0)
      acceleration[c] = body.coordinates.a[at];
  const Angular turn = body.work.handles[handle].turn.H.lazyProduct(angular(acceleration));
  angular(acceleration) = turn;
  return acceleration;
}

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
          calc_section_acceleration(body, section, motion, X, angular(twist), body.coordinates.a)};
}

SpatialMotion observe(const Observer& hub, const space::Pose& X_HB, const InBody& in_body) {
  SpatialMotion m;
  m.p = X_HB.p + X_HB.R * in_body.s;
  m.R = X_HB.R * in_body.R;
  hub.observe(X_HB.R * in_body.velocity, X_HB.R * in_body.acceleration, m);
  return m;
}

/// Returns the section at the tip of the body.
space::Section tip_of(const space::FlexibleBody& body) {
  space::Section tip;
  tip.element = body.elements - 1;
  tip.s0 = body.nodes.back();
  return tip;
}

/// Adds what the stiffening draws a place of a solid by to `shown`; its frame moves by `frame`.
void draw(const BodyData<Space>& body, int place, const SpatialMotion& frame,
          SpatialMotion& shown) {
  const CoordinateBlock& c = body.coordinates;
  const space::PlaceDrawn drawn = calc_solid_drawn(body, place, c.q, c.v, c.a);
  const Position r = frame.R * drawn.place, rate = frame.R * drawn.rate;
  const Position turned = cross(frame.w, r);
  shown.p += r;
  shown.v += turned + rate;
  shown.a += cross(frame.alpha, r) + cross(frame.w, turned) + 2.0 * cross(frame.w, rate) +
             frame.R * drawn.acceleration;
}

/// Takes the foreshortening by bending off `shown`, for a body whose frame moves by `frame`, along
/// its x axis.
void shorten(const BodyData<Space>& body, const space::Section& section, const SpatialMotion& frame,
             SpatialMotion& shown) {
  const CoordinateBlock& c = body.coordinates;
  const space::Foreshortening l =
      calc_foreshortening(body_model_of(body), section, c.q, c.v, c.a, body.work);
  const Position e = frame.R * Position(Position::UnitX());
  const Position e_rate = cross(frame.w, e);
  shown.p -= l.length * e;
  shown.v -= l.length * e_rate + l.rate * e;
  shown.a -= l.length * (cross(frame.alpha, e) + cross(frame.w, e_rate)) + 2.0 * l.rate * e_rate +
             l.acceleration * e;
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
  return X - deform(own, 0) - own.work.handles[0].bias(angular(data.twists[j]));
}

space::Twist calc_handle_acceleration(const SubsystemData<Space>& data, std::size_t j, int handle,
                                      const space::Twist& X) noexcept {
  const HandleMotion& motion = data.bodies[j].work.handles[handle];
  return motion.carry(X) + deform(data.bodies[j], handle) + motion.bias(angular(data.twists[j]));
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
    if (const space::Solid* solid = body.model->body->solid()) {
      const int place =
          is_last ? reading.section.place_number
                  : solid->handles[static_cast<std::size_t>(
                        subsystem.bodies[static_cast<std::size_t>(reading.path[next])].handle)];
      return draw(body, place, frame, short_of);
    }
    shorten(body, is_last ? reading.section : tip_of(*body.model->body->flexible()), frame,
            short_of);
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
