// Reads coordinates, prescribed motions and orientations of joints, and states of controllers.

#include "engine/bodies/kernels/space/joint_values.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/kernels/pitch_control.h"
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

int count_own_values(const Subsystem<Space>& subsystem) {
  return count_joint_values(subsystem) +
         kControlValues * static_cast<int>(subsystem.controls.size());
}

void keep_own_values(std::int64_t step, double t, SubsystemData<Space>& data) noexcept {
  assert(step >= 0);
  double* into = readings_of(data, step);
  for (const BodyData<Space>& body : data.bodies) into = write_values(body, into);
  for (const ControlState& control : data.controls) {
    const space::PrescribedMotion pitch = follow(control, t);
    for (const double value : {control.demands.back(), pitch.value, pitch.rate}) *into++ = value;
  }
}

}  // namespace spoke
