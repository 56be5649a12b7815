#pragma once

// The terms of a body of a planar subsystem, with all that acts on it.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Calculates the terms of body `j` at the state in the table, (P 3), at time t [s].
void calc_terms(const System<Plane>& system, const Subsystem<Plane>& subsystem, double t, int j,
                SubsystemData<Plane>& data) noexcept;

}  // namespace spoke
