#pragma once

// What a simulation tells of markers, joints and sections of a rotor in the plane: Simulation says
// what each is. Markers must be on the table, accelerations and wrenches those of its state.

#include "engine/step/step_context.h"

namespace spoke {

/// `t`: the state's time [s].
MarkerState calc_marker_state(const SystemContext<Plane>& context, const Marker& marker, double t);
Wrench calc_joint_reaction(const StepData<Plane>& data, int blade, int joint);
Wrench calc_hub_reaction(const StepData<Plane>& data);
Wrench calc_section_force(const Rotor& rotor, const SystemContext<Plane>& context,
                          const Marker& marker);

}  // namespace spoke
