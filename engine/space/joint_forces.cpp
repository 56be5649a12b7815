// Forces and energies of the springs and dampers in a joint.

#include "engine/space/joint_forces.h"

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

/// Deflection of the spring in its components; the gradient of half its square is itself, along the
/// velocity of either frame, because a rotation does not turn its own vector.
Angular calc_deflection(const Joint& joint, const JointPrimitive& primitive,
                        const JointState& state, int at) {
  if (primitive.kind == JointPrimitive::Kind::spherical)
    return logarithm(calc_orientation(joint, primitive, state));
  return {state.q[at] - primitive.rest, 0.0, 0.0};
}

}  // namespace

void calc_joint_forces(const Joint& joint, const JointState& state, const ImplicitShares& shares,
                       const double* a, const double* motor, JointForces& forces) noexcept {
  forces = {};
  const bool is_implicit = shares.stiffness != 0.0 || shares.damping != 0.0;
  for_free(joint, [&](const JointPrimitive& primitive, int at) {
    const Angular deflection = primitive.stiffness == 0.0
                                   ? Angular(Angular::Zero())
                                   : calc_deflection(joint, primitive, state, at);
    const double share =
        shares.stiffness * primitive.stiffness + shares.damping * primitive.damping;
    for (int c = 0; c < primitive.components(); ++c) {
      const auto k = static_cast<std::size_t>(at + c);
      forces.tau[k] = -primitive.stiffness * deflection[c] - primitive.damping * state.v[k];
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
  });
  return sum;
}

double calc_dissipation(const Joint& joint, const JointState& state) noexcept {
  double sum = 0.0;
  for_free(joint, [&](const JointPrimitive& primitive, int at) {
    for (int c = 0; c < primitive.components(); ++c)
      sum += primitive.damping * state.v[at + c] * state.v[at + c];
  });
  return sum;
}

}  // namespace spoke::space
