// Reads coordinates, prescribed motions and orientations of joints, and asks actors.

#include "engine/bodies/kernels/space/joint_values.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/kernels/space/table_terms.h"

namespace spoke {
namespace {

using space::JointPrimitive;

/// Writes the values of one joint, and returns the place behind them.
double* write_values(const BodyData<Space>& body, double* into) {
  const space::Joint& joint = body.model->joint.joint;
  const space::JointState state = joint_state_of(body);
  int free = 0, driven = 0;
  for (const JointPrimitive& primitive : joint.sequence()) {
    if (primitive.kind == JointPrimitive::Kind::spherical) {
      const space::Angular theta = logarithm(calc_orientation(joint, primitive, state));
      into = std::copy_n(theta.data(), space::kAngular, into);
      free += space::kAngular;
    } else {
      *into++ = primitive.is_driven ? state.driven[driven++].value : state.q[free++];
    }
  }
  return into;
}

}  // namespace

int count_joint_values(const Subsystem<Space>& subsystem) {
  int count = 0;
  for (const TreeBody<Space>& body : subsystem.bodies)
    for (const JointPrimitive& primitive : body.joint.joint.sequence())
      count += primitive.components();
  return count;
}

std::size_t count_own_values(const System<Space>& system, std::size_t i,
                             const StepData<Space>& data) {
  auto count = static_cast<std::size_t>(count_joint_values(system.subsystems[i]));
  for (const auto& actor : data.actors) count += actor->count_values(i);
  return count;
}

void keep_own_values(std::size_t i, std::int64_t step, double t, StepData<Space>& data) noexcept {
  assert(i < data.subsystems.size() && step >= 0);
  SubsystemData<Space>& own = data.subsystems[i];
  double* into = readings_of(own, step);
  for (const BodyData<Space>& body : own.bodies) into = write_values(body, into);
  for (const auto& actor : data.actors) {
    actor->keep_values(i, t, into);
    into += actor->count_values(i);
  }
}

}  // namespace spoke
