// Walks along a chain from the hub, body by body, with places, velocities and accelerations.

#include "engine/bodies/kernels/plane/relative_motion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "engine/bodies/kernels/plane/handle_motion.h"
#include "models/support/gauss_rule.h"

namespace spoke::plane {
namespace {

/// Returns the motion of a point of a frame that moves by `frame`, at s, with its rates in that
/// frame.
RelativeMotion carry(const RelativeMotion& frame, const Position& s, const Position& s_rate,
                     const Position& s_acceleration) {
  const double w = frame.speed;
  RelativeMotion motion = frame;
  motion.p += frame.R * s;
  motion.v += frame.R * Position(s_rate + w * quarter_turn(s));
  motion.a += frame.R * Position(s_acceleration + frame.acceleration * quarter_turn(s) +
                                 2.0 * w * quarter_turn(s_rate) - w * w * s);
  return motion;
}

/// Returns the values of a node's coordinates u, v, psi.
Twist node_values(const double* flex, const std::array<int, kTwist>& at) {
  return {flex[at[0]], flex[at[1]], flex[at[kRotation]]};
}

/// Turns `motion` by a rotation relative to its frame.
void turn(double sign, const Twist& q, const Twist& v, const Twist& a, RelativeMotion& motion) {
  motion.angle += sign * q[kRotation];
  motion.speed += sign * v[kRotation];
  motion.acceleration += sign * a[kRotation];
}

RelativeMotion calc_outboard_motion(const RelativeMotion& frame, const BodyData<Plane>& body) {
  const CoordinateBlock& c = body.coordinates;
  const Twist q = node_values(c.q, body.outboard_at), v = node_values(c.v, body.outboard_at),
              a = node_values(c.a, body.outboard_at);
  RelativeMotion motion = carry(frame, Position{body.model->body->length + q[0], q[1]},
                                v.head<kPosition>(), a.head<kPosition>());
  turn(1.0, q, v, a, motion);
  return motion;
}

/// Returns the motion of the frame of body `body`, which its inboard handle's motion carries.
RelativeMotion calc_next_frame(RelativeMotion bracket, const SubsystemData<Plane>& data, int body) {
  const BodyData<Plane>& member = data.bodies[body];
  const CoordinateBlock& c = member.coordinates;
  const auto& at = member.inboard_at;
  turn(-1.0, node_values(c.q, at), node_values(c.v, at), node_values(c.a, at), bracket);
  bracket.R = data.poses[body].R;
  return bracket;
}

RelativeMotion root_of(const Subsystem<Plane>& subsystem) {
  RelativeMotion root;
  root.p = subsystem.root.p;
  root.R = subsystem.root.R;
  return root;
}

}  // namespace

RelativeMotion calc_frame_motion(const Subsystem<Plane>& subsystem,
                                 const SubsystemData<Plane>& data, int body) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.bodies.size()));
  RelativeMotion frame = calc_next_frame(root_of(subsystem), data, 0);
  for (int j = 1; j <= body; ++j)
    frame = calc_next_frame(calc_outboard_motion(frame, data.bodies[j - 1]), data, j);
  return frame;
}

RelativeMotion calc_section_motion(const RelativeMotion& frame, const BodyData<Plane>& body,
                                   const Section& section) noexcept {
  const CoordinateBlock& c = body.coordinates;
  const Twist q = section_values(section, c.q), v = section_values(section, c.v),
              a = section_values(section, c.a);
  RelativeMotion motion =
      carry(frame, Position{section.x + q[0], q[1]}, v.head<kPosition>(), a.head<kPosition>());
  turn(1.0, q, v, a, motion);
  motion.R = frame.R * Rotation::from_angle(q[kRotation]);
  return motion;
}

RelativeMotion calc_shown_motion(const Subsystem<Plane>& subsystem,
                                 const SubsystemData<Plane>& data, int body, double station,
                                 const Section& section) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.bodies.size()));
  RelativeMotion frame = calc_next_frame(root_of(subsystem), data, 0);
  RelativeMotion off;  // foreshortening, to be taken off
  for (int j = 0;; ++j) {
    const BodyData<Plane>& member = data.bodies[j];
    if (member.model->stiffening.slope_integral) {
      const Foreshortening f = calc_foreshortening(member, j < body ? 1.0 : station);
      off.R = frame.R;
      off.speed = frame.speed;
      off.acceleration = frame.acceleration;
      off =
          carry(off, Position{f.length, 0.0}, Position{f.rate, 0.0}, Position{f.acceleration, 0.0});
    }
    if (j == body) break;
    frame = calc_next_frame(calc_outboard_motion(frame, member), data, j + 1);
  }
  RelativeMotion motion = calc_section_motion(frame, data.bodies[body], section);
  motion.p -= off.p;
  motion.v -= off.v;
  motion.a -= off.a;
  return motion;
}

// Gauss's rule of three points is exact for the square of a slope.
Foreshortening calc_foreshortening(const BodyData<Plane>& body, double station) noexcept {
  assert(body.model->stiffening && station >= 0.0 && station <= 1.0 + 1e-9);
  using Rule = GaussRule<3>;
  const FlexibleBody& model = *body.model->body;
  const CoordinateBlock& c = body.coordinates;
  Foreshortening sum;
  for (int e = 0; e < model.elements; ++e) {
    const double begin = static_cast<double>(e) / model.elements;
    const double length = std::min(station, (e + 1.0) / model.elements) - begin;
    if (length <= 0.0) break;
    for (std::size_t k = 0; k < Rule::kPoints; ++k) {
      const Section at = make_section(model, body.layout, begin + Rule::places[k] * length);
      const double slope = value_at(at.slope, at.bending_at, c.q);
      const double rate = value_at(at.slope, at.bending_at, c.v);
      const double share = 0.5 * Rule::weights[k] * length * model.length;
      sum.length += share * slope * slope;
      sum.rate += 2.0 * share * slope * rate;
      sum.acceleration +=
          2.0 * share * (rate * rate + slope * value_at(at.slope, at.bending_at, c.a));
    }
  }
  return sum;
}

}  // namespace spoke::plane
