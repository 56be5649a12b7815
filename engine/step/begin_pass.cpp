// Begins the blocks of coordinates of a pass.

#include <cassert>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/table/body_kind.h"
#include "engine/step/integrator/rotation.h"
#include "engine/step/pass_integration.h"

namespace spoke {
namespace {

/// Begins a block with or without an orientation in it.
void begin_coordinates(const Method& method, const PassControl& control,
                       const space::RotationBlock& rotation) {
  const bool has_rotation = rotation.at >= 0;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage != 0) return;
    has_rotation ? predict(*alpha, control.order, rotation)
                 : predict(*alpha, control.order, *rotation.block);
  } else {
    const Rk4& rk4 = std::get<Rk4>(method);
    has_rotation ? advance(rk4, control.stage, rotation)
                 : advance(rk4, control.stage, *rotation.block);
  }
}

/// Returns a joint's coordinates with the orientation of its spherical primitive, if it has one.
space::RotationBlock rotation_block(BodyData<Space>& body) {
  const space::Joint& joint = body.model->joint.joint;
  return {&body.joint.coordinates, joint.spherical_at, body.joint.rotation, joint.spherical_frame};
}

// Coordinates of the joints that carry the bodies; planar joints have none.

void begin_joint(const Method&, const PassControl&, BodyData<Plane>&) {}
void begin_joint(const Method& method, const PassControl& control, BodyData<Space>& body) {
  if (control.is_between_steps() || body.joint.coordinates.size == 0) return;
  begin_coordinates(method, control, rotation_block(body));
}

// What a step needs of the state at which it begins.

void keep_state(BodyData<Plane>& body) {
  if (body.strain) keep_wrenches(*body.model->body, body.coordinates.q, *body.strain);
}
void keep_state(BodyData<Space>& body) { body.kind->keep_state(body); }

// Coordinates of the hub: first the free ones; those that are prescribed follow.

void begin_hub_coordinates(const System<Plane>&, const Method& method, const PassControl& control,
                           StepData<Plane>& data) {
  if (control.is_between_steps()) return;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage == 0) predict(*alpha, control.order, data.hub_coordinates);
  } else {
    advance(std::get<Rk4>(method), control.stage, data.hub_coordinates);
  }
}

/// A free hub has an orientation; the angle about an axle is a plain coordinate.
void begin_hub_coordinates(const System<Space>& system, const Method& method,
                           const PassControl& control, StepData<Space>& data) {
  if (control.is_between_steps()) return;
  const int at = system.hub.support == HubSupport::free ? space::kPosition : -1;
  begin_coordinates(method, control, {&data.hub_coordinates, at, &data.hub_attitude});
}

}  // namespace

template <class World>
void begin_bodies(const Method& method, SubsystemData<World>& subsystem) noexcept {
  assert(subsystem.progress);
  const PassControl& control = subsystem.progress->control;
  if (control.begins_iteration())
    for (BodyData<World>& body : subsystem.bodies) keep_state(body);
  if (control.is_between_steps()) return;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage != 0) return;
    for (BodyData<World>& body : subsystem.bodies) {
      begin_joint(method, control, body);
      predict(*alpha, control.order, body.coordinates);
    }
    return;
  }
  for (BodyData<World>& body : subsystem.bodies) {
    begin_joint(method, control, body);
    advance(std::get<Rk4>(method), control.stage, body.coordinates);
  }
}

bool is_at_new_time(const Method& method, const PassControl& control) noexcept {
  if (control.is_between_steps()) return true;
  if (!std::holds_alternative<Rk4>(method)) return control.stage == 0;
  const auto stage = static_cast<std::size_t>(control.stage);
  // Stages 4 to 6 and 0 stand where stage 3 stood, at the end of the step.
  return stage != 0 && stage < Rk4::kStages && Rk4::nodes[stage] != Rk4::nodes[stage - 1];
}

template <class World>
void begin_hub(const System<World>& system, const Method& method, StepData<World>& data) noexcept {
  const PassControl& control = data.progress[0].control;
  begin_hub_coordinates(system, method, control, data);
  impose_hub_motion(system, control.time, data.hub_coordinates);
  place_axle(system, control.time, data.hub_attitude);
  data.hub = calc_hub_state(data);
}

template void begin_bodies(const Method&, SubsystemData<Plane>&) noexcept;
template void begin_hub(const System<Plane>&, const Method&, StepData<Plane>&) noexcept;
template void begin_bodies(const Method&, SubsystemData<Space>&) noexcept;
template void begin_hub(const System<Space>&, const Method&, StepData<Space>&) noexcept;

}  // namespace spoke
