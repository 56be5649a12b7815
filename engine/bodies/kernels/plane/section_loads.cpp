// Turns forces at sections into terms of bodies, by the shape functions.

#include "engine/bodies/kernels/plane/section_loads.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/kernels/kinematics.h"
#include "models/support/gauss_rule.h"

namespace spoke::plane {
namespace {

/// Returns the force of a load in the body frame [N], at a section that has turned by `rotation` in
/// it.
Position resolve_force(const BodyLoad<Plane>& load, double rotation, const Rotation& R_HB,
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

/// Returns the velocity that a point of the body frame, at `s`, would have if it were fixed to the
/// hub; body frame.
Position hub_velocity_at(const Position& s, const Pose& X_HB, const HubState<Plane>& hub) {
  const Position r = X_HB.p + X_HB.R * s;
  return X_HB.R.inverse() *
         Position(Position(hub.twist.head<kPosition>()) + hub.twist[kRotation] * quarter_turn(r));
}

/// Returns the force of drag at a section, without weight and course, body frame.
Position calc_drag(const BodyDrag<Plane>& drag, const Section& section, const Twist& twist,
                   const Pose& X_HB, const HubState<Plane>& hub, const BodyData<Plane>& body) {
  const Twist q = section_values(section, body.coordinates.q);
  const Twist v = section_values(section, body.coordinates.v);
  const Position s{section.x + q[0], q[1]};
  Position u = Position(twist.head<kPosition>()) + twist[kRotation] * quarter_turn(s) +
               Position(v.head<kPosition>());
  if (drag.relative_to == DragFrame::hub) u -= hub_velocity_at(s, X_HB, hub);
  return -(drag.linear + drag.quadratic * u.norm()) * u;
}

/// Calls visit(section, weight) for the points of a load beyond x [m]. On a stretch that x cuts,
/// the rule is that of the part beyond.
template <class Load, class Visit>
void visit_beyond(const PlacedLoad<Plane, Load>& placed, double x, const BodyData<Plane>& body,
                  const Visit& visit) {
  for (std::size_t k = 0; k < placed.sections.size(); ++k) {
    const LoadPoint& point = placed.load->points[k];
    const auto [begin, end] = point.stretch;
    if (!point.is_per_length() || begin >= x || end <= x) {
      if (point.x >= x) visit(placed.sections[k], point.weight);
      continue;
    }
    const std::size_t of_rule = k % GaussRule<4>::kPoints;
    const double place = x + GaussRule<4>::places[of_rule] * (end - x);
    const FlexibleBody& model = *body.model->body;
    visit(make_section(model, body.layout, place / model.length),
          GaussRule<4>::weights[of_rule] * (end - x));
  }
}

}  // namespace

bool depend_on_pose(const BodyData<Plane>& body) noexcept {
  const std::vector<BodyLoad<Plane>>& loads = body.model->loads;
  return !body.drags.empty() || !body.applied.empty() ||
         std::any_of(loads.begin(), loads.end(),
                     [](const BodyLoad<Plane>& load) { return load.frame == LoadFrame::section; });
}

ForceFrames find_force_frames(const SubsystemData<Plane>& data, int j) noexcept {
  assert(j >= 0 && std::cmp_less(j, data.bodies.size()));
  ForceFrames frames{{}, data.hub->R};
  const auto index = static_cast<std::size_t>(j);
  if (!depend_on_pose(data.bodies[index])) return frames;
  if (data.bodies[index].drags.empty() || data.drag_poses.empty())
    frames.X_HB.R = calc_rotation_to_hub(data, j);
  else
    frames.X_HB = data.drag_poses[index];
  return frames;
}

Position calc_load_force(const BodyLoad<Plane>& load, double rotation,
                         const ForceFrames& frames) noexcept {
  if (load.frame == LoadFrame::hub) return load.force;
  if (load.frame == LoadFrame::inertial) return frames.R_0.inverse() * load.force;
  return frames.X_HB.R * (Rotation::from_angle(rotation) * load.force);
}

Position calc_drag_force(const BodyDrag<Plane>& drag, const Section& section, const Twist& twist,
                         const ForceFrames& frames, const HubState<Plane>& hub,
                         const BodyData<Plane>& body) noexcept {
  return frames.X_HB.R * calc_drag(drag, section, twist, frames.X_HB, hub, body);
}

PartList parts_of_forces(std::size_t j, const SubsystemData<Plane>& data) {
  const BodyData<Plane>& body = data.bodies[j];
  const std::vector<BodyLoad<Plane>>& loads = body.model->loads;
  const bool has_drags = !body.model->drags.empty();
  const bool has_pose = has_drags && !data.drag_poses.empty();
  const SubsystemParts& parts = data.parts;
  PartList list;
  if (depend_on_pose(body)) {
    if (!has_pose) list.push_back(parts.rotations);
    if (!loads.empty() || has_drags) list.push_back(parts.bodies[j].coordinates);
  }
  if (has_drags) graph::add_to(list, parts.twists, parts.hub_state);
  if (has_pose) list.push_back(parts.drag_poses);
  if (std::any_of(loads.begin(), loads.end(),
                  [](const BodyLoad<Plane>& load) { return load.frame == LoadFrame::inertial; }))
    list.push_back(parts.hub_state);
  return list;
}

void add_wrench(const Section& section, const Position& force, double moment, const Twist& twist,
                BodyData<Plane>& body) noexcept {
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
               BodyData<Plane>& body, AppliedTension* tension) noexcept {
  assert(body.loads.size() == body.model->loads.size());
  for (const auto& [load, sections] : body.loads) {
    const double factor = load->course->value(t);
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const Section& section = sections[k];
      const double share = load->points[k].weight * factor;
      const double rotation = value_at(section.slope, section.bending_at, body.coordinates.q);
      const Position force = share * resolve_force(*load, rotation, R_HB, R_0);
      add_wrench(section, force, share * load->moment, twist, body);
      if (tension) tension->add_at(section, force);
    }
  }
}

void add_drags(double t, int j, SubsystemData<Plane>& data, AppliedTension* tension) noexcept {
  assert(j >= 0 && std::cmp_less(j, data.bodies.size()));
  assert(data.drag_poses.empty() || data.drag_poses.size() == data.bodies.size());
  BodyData<Plane>& body = data.bodies[j];
  const Twist& twist = data.twists[j];
  const Pose X_HB = data.drag_poses.empty() ? Pose{} : data.drag_poses[j];
  for (const auto& [drag, sections] : body.drags) {
    const double factor = drag->course->value(t);
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const double share = drag->points[k].weight * factor;
      const Position force = share * calc_drag(*drag, sections[k], twist, X_HB, *data.hub, body);
      add_wrench(sections[k], force, 0.0, twist, body);
      if (tension) tension->add_at(sections[k], force);
    }
  }
}

Twist calc_applied_beyond(double t, const Section& section, int j,
                          const SubsystemData<Plane>& data) noexcept {
  assert(j >= 0 && std::cmp_less(j, data.bodies.size()) && data.poses.size() == data.bodies.size());
  const BodyData<Plane>& body = data.bodies[j];
  const Pose& X_HB = data.poses[j];
  const double* q = body.coordinates.q;
  const double x = section.x - 1e-9 * body.model->body->length;  // a load at the section counts
  const Twist at = section_values(section, q);
  const Position origin{section.x + at[0], at[1]};
  Twist sum = Twist::Zero();
  const auto add = [&](const Section& where, const Position& force, double moment) {
    const Twist moved = section_values(where, q);
    const Position arm = Position{where.x + moved[0], moved[1]} - origin;
    sum += Twist(force.x(), force.y(), moment + arm.x() * force.y() - arm.y() * force.x());
  };
  for (const PlacedLoad<Plane, BodyLoad<Plane>>& placed : body.loads) {
    const BodyLoad<Plane>& load = *placed.load;
    const double factor = load.course->value(t);
    visit_beyond(placed, x, body, [&](const Section& where, double weight) {
      const double rotation = section_values(where, q)[kRotation];
      const Position force = weight * factor * resolve_force(load, rotation, X_HB.R, data.hub->R);
      add(where, force, weight * factor * load.moment);
    });
  }
  for (const PlacedLoad<Plane, BodyDrag<Plane>>& placed : body.drags) {
    const double factor = placed.load->course->value(t);
    visit_beyond(placed, x, body, [&](const Section& where, double weight) {
      const Position force =
          weight * factor * calc_drag(*placed.load, where, data.twists[j], X_HB, *data.hub, body);
      add(where, force, 0.0);
    });
  }
  for (const auto& [place, wrench] : body.applied)
    if (place->x >= x) add(*place, wrench->force, wrench->moment);
  return sum;
}

void add_gravity_power(const Position& gravity, const Twist& twist,
                       BodyData<Plane>& body) noexcept {
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

void add_applied(const Twist& twist, BodyData<Plane>& body, AppliedTension* tension) noexcept {
  for (const auto& [section, wrench] : body.applied) {
    add_wrench(*section, wrench->force, wrench->moment, twist, body);
    if (tension) tension->add_at(*section, wrench->force);
  }
}

}  // namespace spoke::plane
