// Calculates forces and energies of the springs, dampers, stops and friction in a joint.

#include "engine/bodies/space/joint_forces.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::space {
namespace {

/// Calls `visit(primitive, its first coordinate)` for the primitives that have coordinates.
template <class Visit>
void for_free(const Joint& joint, Visit&& visit) {
  int at = 0;
  for (const JointPrimitive& primitive : joint.sequence()) {
    if (primitive.is_driven) continue;
    visit(primitive, at);
    at += primitive.components();
  }
}

/// Returns the deflection of the spring in the components of the velocity. A rotation does not turn
/// its own vector, so that of a spherical spring is the gradient of half its square in either
/// frame.
Angular calc_deflection(const Joint& joint, const JointPrimitive& primitive,
                        const JointState& state, int at) {
  if (primitive.kind == JointPrimitive::Kind::spherical)
    return logarithm(calc_orientation(joint, primitive, state));
  return {state.q[at] - primitive.rest, 0.0, 0.0};
}

/// State of a stop at one coordinate. At the distance d beyond its bound and with the width b its
/// force is k d^2/(2 b) up to d = b, and k (d - b/2) from there on.
struct StopState {
  double force = 0.0;  ///< force of its spring
  double energy = 0.0;
  double share = 0.0;  ///< share of its stiffness and damping: 0 within the bounds, at most 1
};

StopState calc_stop(const JointStop& stop, double q) {
  assert(stop.lower <= stop.upper);
  const double above = q - stop.upper, below = stop.lower - q;
  const double d = std::max(above, below), w = stop.width;
  if (d <= 0.0) return {};
  const double inward = above > 0.0 ? -stop.stiffness : stop.stiffness;
  if (d < w) return {inward * d * d / (2.0 * w), stop.stiffness * d * d * d / (6.0 * w), d / w};
  return {inward * (d - 0.5 * w), stop.stiffness * (0.5 * d * (d - w) + w * w / 6.0), 1.0};
}

/// Friction at a velocity: its force is -size.
struct FrictionState {
  double size = 0.0;
  double tangent = 0.0;  ///< slope of the size, at least 0: one that falls would feed the iteration
  double secant = 0.0;   ///< size/v
};

FrictionState calc_friction(const JointFriction& friction, double v) {
  const double ratio = v / friction.stribeck;
  const double extra = (friction.static_force - friction.force) * std::exp(-ratio * ratio);
  const double F = friction.force + extra, t = std::tanh(v / friction.speed);
  const double by_sign = F * (1.0 - t * t) / friction.speed;
  const double by_size = -2.0 * ratio / friction.stribeck * extra * t;
  const double secant = v == 0.0 ? friction.damping_at_rest() : F * t / v;
  return {F * t, std::max(by_sign + by_size, 0.0), secant};
}

}  // namespace

void calc_joint_forces(const Joint& joint, const JointState& state, const ImplicitShares& shares,
                       const double* a, const double* motor, JointForces& forces) noexcept {
  forces = {};
  const bool is_implicit = shares.stiffness != 0.0 || shares.damping != 0.0;
  for_free(joint, [&](const JointPrimitive& primitive, int at) {
    const bool has_spring = primitive.stiffness != 0.0;
    const Angular deflection =
        has_spring ? calc_deflection(joint, primitive, state, at) : Angular(Angular::Zero());
    const StopState stop = primitive.kind == JointPrimitive::Kind::spherical
                               ? StopState{}
                               : calc_stop(primitive.stop, state.q[at]);
    const double stiffness = primitive.stiffness + stop.share * primitive.stop.stiffness;
    const double damping = primitive.damping + stop.share * primitive.stop.damping;
    double share = shares.stiffness * stiffness + shares.damping * damping;
    FrictionState friction;
    if (primitive.friction.acts()) {
      friction = calc_friction(primitive.friction, state.v[at]);
      share += shares.damping * std::max(friction.tangent, shares.secant * friction.secant);
    }
    for (int c = 0; c < primitive.components(); ++c) {
      const auto k = static_cast<std::size_t>(at + c);
      forces.tau[k] = stop.force - primitive.stiffness * deflection[c] - damping * state.v[k];
      if (primitive.friction.acts()) forces.tau[k] -= friction.size;
      if (motor) forces.tau[k] += motor[k];
      if (!is_implicit) continue;
      forces.tau[k] += share * a[k];
      forces.share[k] = share;
    }
  });
}

double calc_spring_energy(const Joint& joint, const JointState& state) noexcept {
  double sum = 0.0;
  for_free(joint, [&](const JointPrimitive& primitive, int at) {
    sum += 0.5 * primitive.stiffness * calc_deflection(joint, primitive, state, at).squaredNorm();
    if (primitive.kind != JointPrimitive::Kind::spherical)
      sum += calc_stop(primitive.stop, state.q[at]).energy;
  });
  return sum;
}

double calc_dissipation(const Joint& joint, const JointState& state) noexcept {
  double sum = 0.0;
  for_free(joint, [&](const JointPrimitive& primitive, int at) {
    double damping = primitive.damping;
    if (primitive.kind != JointPrimitive::Kind::spherical)
      damping += calc_stop(primitive.stop, state.q[at]).share * primitive.stop.damping;
    for (int c = 0; c < primitive.components(); ++c)
      sum += damping * state.v[at + c] * state.v[at + c];
    if (primitive.friction.acts())
      sum += calc_friction(primitive.friction, state.v[at]).size * state.v[at];
  });
  return sum;
}

}  // namespace spoke::space
