#pragma once

// Views of markers, joints, sections and the hub of a model, as Simulation documents them. Markers
// must be on the table; accelerations and wrenches must be those of its state.

#include "engine/step/step_context.h"
#include "engine/tree_shape.h"

namespace spoke {

/// Returns the motion of a marker; `t` is the time of the state [s].
MarkerState calc_marker_state(const SystemContext<Plane>& context, const Marker& marker, double t);
MarkerState calc_marker_state(const SystemContext<Space>& context, const Marker& marker, double t);

Wrench calc_joint_reaction(const SystemContext<Plane>& context, int subsystem, int joint);
Wrench calc_joint_reaction(const SystemContext<Space>& context, int subsystem, int joint);

template <class World>
Wrench calc_hub_reaction(const StepData<World>& data);

Wrench calc_section_force(const Rotor& rotor, const SystemContext<Plane>& context,
                          const Marker& marker);
/// Returns the force in a section. Throws InputError if the marker is on a rigid body.
Wrench calc_section_force(const SystemContext<Space>& context, const Marker& marker);

/// Returns velocities and accelerations of the frame of the hub, in the inertial frame, at time t
/// [s].
MarkerState calc_hub_frame(const SystemContext<Plane>& context, double t);
MarkerState calc_hub_frame(const SystemContext<Space>& context, double t);

}  // namespace spoke
