#pragma once

// What a simulation tells of markers, joints, sections and the hub of a model: Simulation says what
// each is. Markers must be on the table, accelerations and wrenches those of its state.

#include "engine/step/step_context.h"
#include "engine/tree_shape.h"

namespace spoke {

/// `t`: the state's time [s].
MarkerState calc_marker_state(const SystemContext<Plane>& context, const Marker& marker, double t);
MarkerState calc_marker_state(const SystemContext<Space>& context, const Marker& marker, double t);

Wrench calc_joint_reaction(const SystemContext<Plane>& context, int blade, int joint);
Wrench calc_joint_reaction(const SystemContext<Space>& context, int tree, int joint);

template <class World>
Wrench calc_hub_reaction(const StepData<World>& data);

Wrench calc_section_force(const Rotor& rotor, const SystemContext<Plane>& context,
                          const Marker& marker);
/// Throws InputError if the marker is on a rigid body.
Wrench calc_section_force(const SystemContext<Space>& context, const Marker& marker);

/// Velocities and accelerations of the hub's frame, in the inertial frame, at time t [s].
MarkerState calc_hub_frame(const SystemContext<Plane>& context, double t);
MarkerState calc_hub_frame(const SystemContext<Space>& context, double t);

}  // namespace spoke
