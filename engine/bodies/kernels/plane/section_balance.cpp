// Integrates inertia forces and momenta along elements, and adds loads and joints.

#include "engine/bodies/kernels/plane/section_balance.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/kernels/plane/handle_motion.h"
#include "engine/bodies/kernels/plane/section_loads.h"
#include "models/support/gauss_rule.h"

namespace spoke::plane {
namespace {

double cross(const Position& a, const Position& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Adds points between `from` and `to` [m], with the share of the mass that each stands for;
/// `density` is the mass per length at a place [kg/m].
template <class Density>
void add_stretch(const FlexibleBody& body, const FlexLayout& layout, double from, double to,
                 const Density& density, std::vector<MassPoint>& points) {
  if (to <= from) return;
  for (std::size_t k = 0; k < GaussRule<4>::kPoints; ++k) {
    const double x = from + GaussRule<4>::places[k] * (to - from);
    points.push_back({GaussRule<4>::weights[k] * (to - from) * density(x), 0.0,
                      make_section(body, layout, x / body.length)});
  }
}

/// Returns the place of a section in its body's frame.
Position place_of(const Section& section, const double* q) {
  return Position{section.x, 0.0} + Position(section_values(section, q).head<kPosition>());
}

/// Returns qf^T KG qf [kg m^2].
double calc_centrifugal_inertia(const BodyData<Plane>& body) {
  assert(body.model->stiffening.centrifugal);
  const SymmetricBand<3>& KG = *body.model->stiffening.centrifugal;
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

Twist calc_hub_acceleration(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                            double t) noexcept {
  assert(i < data.subsystems.size());
  if (!data.is_coupled) return data.subsystems[i].prescribed.acceleration;
  const double* a = data.hub_coordinates.a;
  const Position linear =
      data.hub.R.inverse() * Position(Position{a[0], a[1]} - system.gravity_at(t));
  return {linear.x(), linear.y(), a[kRotation]};
}

std::vector<MassPoint> make_mass_points(const FlexibleBody& body, const FlexLayout& layout,
                                        double from) {
  assert(from >= 0.0 && from <= body.length * (1.0 + 1e-9));
  std::vector<MassPoint> points;
  const double l = body.length / body.elements, uniform = body.mass / body.length;
  for (int e = 0; e < body.elements; ++e) {
    const double begin = std::max(from, e * l), end = (e + 1) * l;
    if (body.pieces.empty())
      add_stretch(
          body, layout, begin, end, [uniform](double) { return uniform; }, points);
    for (const BeamPiece& piece : body.pieces)
      add_stretch(
          body, layout, std::max(begin, piece.begin), std::min(end, piece.end),
          [&piece](double x) { return piece.at(piece.mass_per_length, x); }, points);
  }
  for (const BodyMass& point : body.masses)
    if (point.x >= from - 1e-9 * body.length)
      points.push_back(
          {point.mass, point.inertia, make_section(body, layout, point.x / body.length)});
  points.shrink_to_fit();
  return points;
}

Twist calc_section_load(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                        double t, int body, const Section& section,
                        std::span<const MassPoint> outboard) noexcept {
  assert(i < data.subsystems.size());
  assert(body >= 0 && std::cmp_less(body, data.subsystems[i].bodies.size()));
  const Subsystem<Plane>& subsystem = system.subsystems[i];
  const SubsystemData<Plane>& own = data.subsystems[i];
  const BodyData<Plane>& member = own.bodies[body];
  const CoordinateBlock& c = member.coordinates;
  const double w = own.twists[body][kRotation];
  const FrameAcceleration frame =
      calc_frame_acceleration(calc_hub_acceleration(system, i, data, t), own.hub->twist[kRotation],
                              calc_frame_motion(subsystem, own, body));
  const Position at = place_of(section, c.q);
  Position force = Position::Zero();
  double moment = 0.0;
  for (const auto& [mass, inertia, p] : outboard) {
    const Position s = place_of(p, c.q);
    const Position s_rate = section_values(p, c.v).head<kPosition>();
    const Twist relative = section_values(p, c.a);
    const Position a = frame.linear + frame.angular * quarter_turn(s) +
                       2.0 * w * quarter_turn(s_rate) - w * w * s +
                       Position(relative.head<kPosition>());
    force -= mass * a;
    moment -= mass * cross(s - at, a) + inertia * (frame.angular + relative[kRotation]);
  }
  const Twist applied = calc_applied_beyond(t, section, body, own);
  force += applied.head<kPosition>();
  moment += applied[kRotation];
  if (const auto next = static_cast<std::size_t>(body) + 1; next < own.bodies.size()) {
    const Twist joint = -(own.joints[next].R * own.joint_loads[next]);
    const Position f = joint.head<kPosition>();
    force += f;
    moment += joint[kRotation] + cross(calc_outboard_position(member) - at, f);
  }
  return {force.x(), force.y(), moment};
}

Twist calc_momentum(const SubsystemData<Plane>& data, std::span<const MassPoints> masses) noexcept {
  assert(masses.size() == data.bodies.size() && data.poses.size() == data.bodies.size());
  const HubState<Plane>& hub = *data.hub;
  Position linear = Position::Zero();
  double angular = 0.0;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<Plane>& body = data.bodies[j];
    const Twist& twist = data.twists[j];
    Position momentum = Position::Zero();
    double about_frame = 0.0;
    for (const auto& [mass, inertia, p] : *masses[j]) {
      const Position s = place_of(p, body.coordinates.q);
      const Twist relative = section_values(p, body.coordinates.v);
      const Position v = Position(twist.head<kPosition>()) + twist[kRotation] * quarter_turn(s) +
                         Position(relative.head<kPosition>());
      momentum += mass * v;
      about_frame += mass * cross(s, v) + inertia * (twist[kRotation] + relative[kRotation]);
    }
    const Position origin = hub.p + hub.R * data.poses[j].p;
    const Position P = hub.R * (data.poses[j].R * momentum);
    linear += P;
    angular += cross(origin, P) + about_frame;
    if (!body.model->stiffening.centrifugal) continue;
    angular -= hub.twist[kRotation] * calc_centrifugal_inertia(body);
  }
  return {linear.x(), linear.y(), angular};
}

}  // namespace spoke::plane
