#pragma once

// Views of markers, joints, sections and the hub of a model, as Simulation documents them. Markers
// must be on the table; accelerations and wrenches must be those of its state.

#include <string>
#include <string_view>
#include <vector>

#include "engine/load.h"
#include "engine/step/step_context.h"
#include "engine/tree_shape.h"

namespace spoke {

/// Returns the motion of a marker; `t` is the time of the state [s].
MarkerState calc_marker_state(const SystemContext<Plane>& context, const Marker& marker, double t);
MarkerState calc_marker_state(const SystemContext<Space>& context, const Marker& marker, double t);

Wrench calc_joint_reaction(const SystemContext<Plane>& context, int subsystem, int joint);
Wrench calc_joint_reaction(const SystemContext<Space>& context, int subsystem, int joint);

/// Returns the index of the loop of that name. Throws InputError, with the nearest name, if
/// `subsystem` has none.
std::size_t find_loop(const std::vector<LoopModel>& loops, const std::string& subsystem,
                      std::string_view name);
/// Returns the wrench of loop `k` of subsystem `i` on its place `from`, about it, in the inertial
/// frame, at a state at time t [s].
template <class World>
Wrench calc_loop_wrench(const SystemContext<World>& context, std::size_t i, std::size_t k,
                        double t);

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

/// Returns the motion of an anchor, or of the mount (-1), in the inertial frame, at time t [s]; its
/// axes are those of H at rest, of what a support stands on those of the description.
MarkerMotion calc_carrier_frame(const SystemContext<Plane>& context, int anchor, double t);
MarkerMotion calc_carrier_frame(const SystemContext<Space>& context, int anchor, double t);

}  // namespace spoke
