#pragma once

// Sums of the applied forces (loads of the scenario and of the user's, drag) along a tree, in the
// hub's frame: the tension in its bodies depends on them (docs/formulation.md, section 2).

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Finds the bodies whose tension depends on applied forces, and makes room for the sums. Loads
/// must have been placed; may be called again when there are more.
template <class World>
void place_applied_forces(StepData<World>& data);

/// Whether a joint hands a force of its own on to the bodies that carry it: see JointSlide.
inline bool has_slide(const TreeBody<Plane>&) { return false; }
inline bool has_slide(const TreeBody<Space>& body) { return body.joint.slide.has_value(); }

/// Sets the sums of subsystem `i` at the state in the table and time t [s].
void calc_applied_forces(const System<Plane>& system, std::size_t i, double t,
                         StepData<Plane>& data) noexcept;
void calc_applied_forces(const System<Space>& system, std::size_t i, double t,
                         StepData<Space>& data) noexcept;
/// Return the parts that they depend on.
PartList parts_of_applied_forces(std::size_t i, const StepData<Plane>& data);
PartList parts_of_applied_forces(std::size_t i, const StepData<Space>& data);

/// Sets data.flight_acceleration of a hub that flies, from the sums of the subsystems and the loads
/// on the hub.
template <class World>
void calc_flight_acceleration(const System<World>& system, double t,
                              StepData<World>& data) noexcept;
/// Returns the parts that it depends on.
template <class World>
PartList parts_of_flight_acceleration(const StepData<World>& data);

}  // namespace spoke
