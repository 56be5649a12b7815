// Integrates inertia forces and momenta along elements, and adds loads and joints.

#include "engine/kernels/section_balance.h"

#include <algorithm>
#include <array>

#include "engine/kernels/body_terms.h"
#include "engine/kernels/kinematics.h"

namespace spoke {
namespace {

double cross(const Position& a, const Position& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Calls visit(mass, section) for points along a body from a station to its outboard end, with the
/// share of the mass that each stands for: a rule of four points an element, exact for what is of
/// degree seven.
template <class Visit>
void visit_mass(const BodyData& body, double station, const Visit& visit) {
  static constexpr std::array<double, 4> places{0.069431844202973712, 0.33000947820757187,
                                                0.66999052179242813, 0.93056815579702629};
  static constexpr std::array<double, 4> weights{0.17392742256872693, 0.32607257743127307,
                                                 0.32607257743127307, 0.17392742256872693};
  const FlexibleBody& model = *body.model->body;
  for (int e = 0; e < model.elements; ++e) {
    const double begin = std::max(station, static_cast<double>(e) / model.elements);
    const double length = (e + 1.0) / model.elements - begin;
    if (length <= 0.0) continue;
    for (std::size_t k = 0; k < places.size(); ++k)
      visit(weights[k] * length * model.mass,
            make_section(model, body.layout, begin + places[k] * length));
  }
}

/// Place of a section in its body's frame.
Position place_of(const Section& section, const double* q) {
  return Position{section.x, 0.0} + Position(section_values(section, q).head<kPosition>());
}

/// qf^T KG qf [kg m^2].
double calc_centrifugal_inertia(const BodyData& body) {
  const SymmetricBand<3>& KG = *body.model->centrifugal_stiffness;
  const double* v = body.coordinates.q + body.layout.v();
  double sum = 0.0;
  for (int i = 0; i < KG.size(); ++i) sum += v[i] * KG.row(i, v);
  return sum;
}

/// Acceleration less gravity and rotation of a body's frame, in that frame.
struct FrameAcceleration {
  Position linear;
  double angular;
};

FrameAcceleration calc_frame_acceleration(const Twist& hub_acceleration, double w0,
                                          const RelativeMotion& frame) {
  const double alpha = hub_acceleration[kRotation];
  const Position a = Position(hub_acceleration.head<kPosition>()) + frame.a +
                     2.0 * w0 * quarter_turn(frame.v) + alpha * quarter_turn(frame.p) -
                     w0 * w0 * frame.p;
  return {frame.R.inverse() * a, alpha + frame.acceleration};
}

}  // namespace

Twist calc_hub_acceleration(const System& system, std::size_t i, const StepData& data) noexcept {
  if (!data.is_coupled) return data.subsystems[i].prescribed.acceleration;
  const double* a = data.hub_coordinates.a;
  const Position linear = data.hub.R.inverse() * Position(Position{a[0], a[1]} - system.gravity);
  return {linear.x(), linear.y(), a[kRotation]};
}

void keep_joint_loads(const Subsystem& subsystem, SubsystemData& data) noexcept {
  for (std::size_t j = 0; j < data.bodies.size(); ++j)
    data.joint_loads[j] = data.wrenches[j].inboard;
  const Rotation to_blade = subsystem.root.R.inverse() * data.rotations[0];
  data.root_load = Twist::Zero() - to_blade * data.joint_loads[0];  // never -0
  if (!subsystem.bodies.front().centrifugal_stiffness) return;
  double inertia = 0.0, rate = 0.0;
  for (const BodyData& body : data.bodies) {
    inertia += body.terms.centrifugal_inertia;
    rate += body.terms.centrifugal_rate;
  }
  data.root_load[kRotation] +=
      inertia * (*data.hub_acceleration)[kRotation] + 2.0 * data.hub->twist[kRotation] * rate;
}

Twist calc_section_load(const System& system, std::size_t i, const StepData& data, double t,
                        int body, const Section& section) noexcept {
  const Subsystem& subsystem = system.subsystems[i];
  const SubsystemData& blade = data.subsystems[i];
  const BodyData& member = blade.bodies[body];
  const CoordinateBlock& c = member.coordinates;
  const double w = blade.twists[body][kRotation];
  const FrameAcceleration frame =
      calc_frame_acceleration(calc_hub_acceleration(system, i, data), blade.hub->twist[kRotation],
                              calc_frame_motion(subsystem, blade, body));
  const Position at = place_of(section, c.q);
  Position force = Position::Zero();
  double moment = 0.0;
  visit_mass(member, section.x / member.model->body->length, [&](double mass, const Section& p) {
    const Position s = place_of(p, c.q);
    const Position s_rate = section_values(p, c.v).head<kPosition>();
    const Position a = frame.linear + frame.angular * quarter_turn(s) +
                       2.0 * w * quarter_turn(s_rate) - w * w * s +
                       Position(section_values(p, c.a).head<kPosition>());
    force -= mass * a;
    moment -= mass * cross(s - at, a);
  });
  const Twist applied = calc_applied_beyond(t, blade.poses[body].R, blade.hub->R, section, member);
  force += applied.head<kPosition>();
  moment += applied[kRotation];
  if (const auto next = static_cast<std::size_t>(body) + 1; next < blade.bodies.size()) {
    const Twist joint = -(blade.rotations[next] * blade.joint_loads[next]);
    const Position f = joint.head<kPosition>();
    force += f;
    moment += joint[kRotation] + cross(calc_outboard_position(member) - at, f);
  }
  return {force.x(), force.y(), moment};
}

Twist calc_momentum(const SubsystemData& data) noexcept {
  const HubState& hub = *data.hub;
  Position linear = Position::Zero();
  double angular = 0.0;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData& body = data.bodies[j];
    const Twist& twist = data.twists[j];
    Position momentum = Position::Zero();
    double about_frame = 0.0;
    visit_mass(body, 0.0, [&](double mass, const Section& p) {
      const Position s = place_of(p, body.coordinates.q);
      const Position v = Position(twist.head<kPosition>()) + twist[kRotation] * quarter_turn(s) +
                         Position(section_values(p, body.coordinates.v).head<kPosition>());
      momentum += mass * v;
      about_frame += mass * cross(s, v);
    });
    const Position origin = hub.p + hub.R * data.poses[j].p;
    const Position P = hub.R * (data.poses[j].R * momentum);
    linear += P;
    angular += cross(origin, P) + about_frame;
    if (!body.model->centrifugal_stiffness) continue;
    angular -= hub.twist[kRotation] * calc_centrifugal_inertia(body);
  }
  return {linear.x(), linear.y(), angular};
}

}  // namespace spoke
