// Allocates table and formulation for a system.

#include <algorithm>
#include <cassert>

#include "engine/bodies/act/place_actors.h"
#include "engine/bodies/kernels/applied_forces.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/space/put_joint.h"
#include "engine/step/formulation/loops/shared_loops.h"
#include "engine/step/loops/loop_start.h"
#include "engine/step/step_context.h"
#include "engine/step/step_errors.h"

namespace spoke {
namespace {

/// Returns the shares of Mff and K in the constant block of an implicit step: Mhat = Mff + beta'
/// h^2 K + gamma' h D, with Rayleigh damping D; and the share of tension.
ElasticShares implicit_shares(const Method& method, const Damping& damping) {
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  if (!alpha) return {};
  return {1.0 + alpha->velocity_gain * damping.mass_factor,
          alpha->position_gain + alpha->velocity_gain * damping.stiffness_factor,
          alpha->velocity_gain, alpha->position_gain};
}

}  // namespace

namespace {

/// Lets the integrator close loops that are rigid.
template <class World>
void close_loops_by(SystemContext<World>& context) {
  // Openings that are left are some 1e-14 of the model's length then.
  constexpr double kClosing = 1e-7;
  bool has_rigid = false;
  for (const Subsystem<World>& subsystem : context.system.subsystems)
    for (const LoopModel& loop : subsystem.loops)
      for (const LoopRow& row : loop.rows) has_rigid |= row.is_rigid();
  if (!has_rigid) return;
  context.integrator.limits.closing = kClosing * std::min(1.0, context.data.length);
  if (auto* rk4 = std::get_if<Rk4>(&context.integrator.method)) rk4->projects = true;
}

// Start of the motion, besides the drive's.

void set_start_of_hub(const System<Plane>&, StepData<Plane>&) {}

void set_start_of_hub(const System<Space>& system, StepData<Space>& data) {
  data.hub_attitude.reference = system.hub.orientation;
  if (system.hub.support != HubSupport::free) return;
  std::copy_n(system.hub.position.data(), space::kPosition, data.hub_coordinates.q);
  std::copy_n(system.hub.velocity.data(), space::kTwist, data.hub_coordinates.v);
}

void set_start_of_axles(const System<Plane>&, StepData<Plane>&) {}
void set_start_of_axles(const System<Space>& system, StepData<Space>& data) {
  for (const SupportedRotor& rotor : system.rotors) {
    auto& bodies = data.subsystems[static_cast<std::size_t>(rotor.subsystem)].bodies;
    BodyData<Space>& driven = bodies[static_cast<std::size_t>(rotor.driven)];
    const space::JointCourse& course = driven.model->joint.course;
    const double speed = course.drive_ratio * calc_initial_speed(*course.drive);
    if (driven.joint.coordinates.size > 0) driven.joint.coordinates.v[0] = speed;
    if (rotor.driven != rotor.body)
      bodies[static_cast<std::size_t>(rotor.body)].joint.coordinates.v[0] =
          speed / rotor.gear_ratio;
  }
}

void set_start(const System<Plane>&, StepData<Plane>&) {}

void set_start(const TreeBody<Space>& model, BodyData<Space>& body) {
  space::JointData& joint = body.joint;
  const space::JointCourse& course = model.joint.course;
  put_joint(model.joint.joint, course.initial.data(), joint);
  std::copy(course.initial_speed.begin(), course.initial_speed.end(), joint.coordinates.v);
}

void set_start(const System<Space>& system, StepData<Space>& data) {
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < data.subsystems[i].bodies.size(); ++j)
      set_start(system.subsystems[i].bodies[j], data.subsystems[i].bodies[j]);
}

}  // namespace

template <class World>
void allocate(SystemContext<World>& context, int window_steps) {
  assert(window_steps >= 1 && step_size(context.integrator) > 0.0);
  const Method& method = context.integrator.method;
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  const int history = alpha ? int{GeneralizedAlpha::count} : int{Rk4::count};
  StepData<World>& data = context.data;
  const bool is_coupled = context.formulation == Formulation::augmented ||
                          !is_prescribed(context.system) || !context.system.rotors.empty() ||
                          context.loads_tie_subsystems || !context.system.shared_loops.empty();
  allocate(context.system, {history, !alpha, is_coupled, window_steps, context.linear_range}, data);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    allocate_loops(context.system.subsystems[i], data.subsystems[i]);
  allocate_shared_loops(context.system, data);
  set_lengths(data);
  close_loops_by(context);
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (BodyData<World>& body : subsystem.bodies) {
      CoordinateBlock& block = body.coordinates;
      const bool is_split = alpha && !has_nonlinear_strain(body);
      body.q_elastic = is_split ? block.history[GeneralizedAlpha::predicted_q] : block.q;
      body.v_elastic = is_split ? block.history[GeneralizedAlpha::predicted_v] : block.v;
      body.v_modal = block.v;
    }
  allocate(context.system, context.formulation, implicit_shares(method, context.system.damping),
           data, context.work);
  set_start(context.system, data);
  place_actors(context.system, data);
  place_applied_forces(data);
  put_hub_at_start(context);
  start_loops(context);
}

template <class World>
void put_hub_at_start(SystemContext<World>& context) {
  StepData<World>& data = context.data;
  data.hub_coordinates.v[World::kAxial] = calc_initial_speed(context.system.hub.drive);
  set_start_of_hub(context.system, data);
  set_start_of_axles(context.system, data);
  impose_hub_motion(context.system, 0.0, data.hub_coordinates);
  place_axle(context.system, 0.0, data.hub_attitude);
}

template void allocate(SystemContext<Plane>&, int);
template void allocate(SystemContext<Space>&, int);
template void put_hub_at_start(SystemContext<Plane>&);
template void put_hub_at_start(SystemContext<Space>&);

}  // namespace spoke
