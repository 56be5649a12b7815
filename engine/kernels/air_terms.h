#pragma once

// Air on blades in the table: its place, the forces of an evaluation, and the states of inflow and
// stall from step to step.

#include "engine/table/step_data.h"

namespace spoke {

/// Puts air on the table of a system, which is allocated: on every subsystem that has some. Its
/// states are those of equilibrium at first.
void place_air(const System<Space>& system, StepData<Space>& data);
inline void place_air(const System<Plane>&, StepData<Plane>&) {}

/// Evaluates the air on a subsystem at time `t` [s], `elapsed` [s] after its states were kept, at
/// the kinematics in the table: sets its wrenches, and the states reached. iterates: an evaluation
/// at this time precedes, whose induced velocities are kept. Precondition: it has air.
void evaluate_air(double t, double elapsed, bool iterates, const System<Space>& system,
                  std::size_t i, SubsystemData<Space>& data) noexcept;
inline void evaluate_air(double, double, bool, const System<Plane>&, std::size_t,
                         SubsystemData<Plane>&) noexcept {}

/// Keeps the states that the last evaluation has reached.
template <class World>
void keep_air(SubsystemData<World>& data) noexcept;

}  // namespace spoke
