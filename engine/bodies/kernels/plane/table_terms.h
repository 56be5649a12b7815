#pragma once

// The terms of a body of a planar subsystem, with all that acts on it.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Calculates the terms of body `j` at the state in the table, (P 3), at time t [s].
void calc_terms(const System<Plane>& system, const Subsystem<Plane>& subsystem, double t, int j,
                SubsystemData<Plane>& data) noexcept;
/// Returns the parts on which they depend, of those the ones that its options make them depend on;
/// `has_implicit`: whether any pass is implicit.
PartList parts_of_terms(const System<Plane>& system, std::size_t i, std::size_t j,
                        bool has_implicit, const StepData<Plane>& data);

}  // namespace spoke
