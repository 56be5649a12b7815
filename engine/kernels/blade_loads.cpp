// Turns forces at sections into terms of bodies, by the shape functions.

#include "engine/kernels/blade_loads.h"

namespace spoke {
namespace {

/// Force of a load in the body frame [N], at a section that has turned by `rotation` in it.
Position resolve_force(const BodyLoad& load, double rotation, const Rotation& R_HB,
                       const Rotation& R_0) {
  switch (load.frame) {
    case LoadFrame::inertial:
      return (R_0 * R_HB).inverse() * load.force;
    case LoadFrame::hub:
      return R_HB.inverse() * load.force;
    case LoadFrame::section:
      break;
  }
  return Rotation::from_angle(rotation) * load.force;
}

/// The velocity that a point of the body frame, at `s`, would have if it were fixed to the hub;
/// body frame.
Position hub_velocity_at(const Position& s, const Pose& X_HB, const HubState& hub) {
  const Position r = X_HB.p + X_HB.R * s;
  return X_HB.R.inverse() *
         Position(Position(hub.twist.head<kPosition>()) + hub.twist[kRotation] * quarter_turn(r));
}

}  // namespace

void add_wrench(const Section& section, const Position& force, double moment, const Twist& twist,
                BodyData& body) noexcept {
  const Twist q = section_values(section, body.coordinates.q);
  const Twist v = section_values(section, body.coordinates.v);
  const Position s{section.x + q[0], q[1]};
  const double torque = s.x() * force.y() - s.y() * force.x() + moment;
  body.terms.Q += Twist(force.x(), force.y(), torque);
  for (std::size_t k = 0; k < section.axial.size(); ++k)
    if (const int at = section.axial_at[k]; at > 0) body.Q_f[at] += section.axial[k] * force.x();
  for (std::size_t k = 0; k < section.deflection.size(); ++k)
    if (const int at = section.bending_at[k]; at > 0)
      body.Q_f[at] += section.deflection[k] * force.y() + section.slope[k] * moment;
  body.terms.load_power +=
      force.dot(Position(twist.head<kPosition>()) + Position(v.head<kPosition>())) +
      torque * twist[kRotation] + moment * v[kRotation];
}

void add_loads(double t, const Rotation& R_HB, const Rotation& R_0, const Twist& twist,
               BodyData& body) noexcept {
  for (const auto& [load, sections] : body.loads) {
    const double factor = load->course->value(t);
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const Section& section = sections[k];
      const double share = load->points[k].weight * factor;
      const double rotation = value_at(section.slope, section.bending_at, body.coordinates.q);
      const Position force = share * resolve_force(*load, rotation, R_HB, R_0);
      add_wrench(section, force, share * load->moment, twist, body);
    }
  }
}

void add_drags(double t, int j, SubsystemData& data) noexcept {
  BodyData& body = data.bodies[j];
  const Twist& twist = data.twists[j];
  for (const auto& [drag, sections] : body.drags) {
    const double factor = drag->course->value(t);
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const Section& section = sections[k];
      const Twist q = section_values(section, body.coordinates.q);
      const Twist v = section_values(section, body.coordinates.v);
      const Position s{section.x + q[0], q[1]};
      Position u = Position(twist.head<kPosition>()) + twist[kRotation] * quarter_turn(s) +
                   Position(v.head<kPosition>());
      if (drag->relative_to == DragFrame::hub)
        u -= hub_velocity_at(s, data.drag_poses[j], *data.hub);
      const double share = drag->points[k].weight * factor;
      const Position force = -share * (drag->linear + drag->quadratic * u.norm()) * u;
      add_wrench(section, force, 0.0, twist, body);
    }
  }
}

void add_gravity_power(const Position& gravity, const Twist& twist, BodyData& body) noexcept {
  const FlexibleBody& model = *body.model->body;
  const double* ud = body.coordinates.v + body.layout.u();
  const double* vd = body.coordinates.v + body.layout.v();
  Position S_rate = Position::Zero();
  for (int i = 0; i < model.axial(); ++i) S_rate.x() += model.S_axial[i] * ud[i];
  for (int i = 0; i < model.bending(); ++i) S_rate.y() += model.S_bending[i] * vd[i];
  const Position momentum = model.mass * Position(twist.head<kPosition>()) +
                            twist[kRotation] * quarter_turn(body.terms.S) + S_rate;
  body.terms.load_power += gravity.dot(momentum);
}

}  // namespace spoke
