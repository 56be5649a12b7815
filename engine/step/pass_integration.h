#pragma once

// Start and end of a pass, where it meets the integrator: at its start coordinates are set, at its
// end the integrator takes the accelerations found, the state is checked, all reports are summed in
// fixed order, and the progress moves on.

#include "engine/bodies/table/step_data.h"
#include "engine/step/integrator/step_control.h"

namespace spoke {

/// Sets the coordinates of a subsystem's bodies for the pass.
template <class World>
void begin_bodies(const Method& method, SubsystemData<World>& subsystem) noexcept;

/// Whether a pass stands at another time than the one before it.
bool is_at_new_time(const Method& method, const PassControl& control) noexcept;

/// Sets the hub's coordinates, the prescribed ones by the drive, and its state, in a coupled
/// system.
template <class World>
void begin_hub(const System<World>& system, const Method& method, StepData<World>& data) noexcept;

/// Hands `body.a_found` to the integrator and reports the change and whether the deformation has
/// left its limits (a coordinate not finite, a displacement beyond the body's length, a rotation
/// beyond a half turn) or the linear range.
template <class World>
void complete_body(const Method& method, const PassControl& control,
                   BodyData<World>& body) noexcept;

/// Hands the hub's acceleration to the integrator, in a coupled system; prescribed components
/// follow the drive. Reports the largest change of a free coordinate.
template <class World>
void complete_hub(const System<World>& system, const Method& method,
                  StepData<World>& data) noexcept;
/// Returns the parts that this depends on besides the hub's acceleration.
template <class World>
PartList parts_of_completed_hub(const System<World>& system, const Method& method,
                                const StepData<World>& data);

/// Ends the pass of a subsystem with its own progress, in a system that is not coupled.
template <class World>
void finish_subsystem(const typename World::Hub& hub, const Integrator& integrator,
                      const Window& window, SubsystemData<World>& subsystem) noexcept;

/// Ends the pass of a coupled system.
template <class World>
void finish_system(const System<World>& system, const Integrator& integrator,
                   StepData<World>& data) noexcept;

/// Solves (P 9) in a system that is not coupled, where the hub's whole motion is prescribed, for
/// every step that all subsystems have completed since the window began: the reaction, from the
/// shares of the subsystems in their order, and the hub's motion.
template <class World>
void record_reactions(const System<World>& system, const Integrator& integrator,
                      StepData<World>& data) noexcept;

/// Returns the last step that all subsystems have completed; -1: not even the start.
std::int64_t last_complete_step(const StepTable& data) noexcept;

}  // namespace spoke
