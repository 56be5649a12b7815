#pragma once

// The identity of a model, by which a saved state is known to belong to it.

#include <string>

#include "engine/formulation.h"
#include "models/scenario.h"

namespace spoke {

/// Returns all that determines the bits of a simulation's states, as JSON shaped like a scenario
/// file: the whole scenario without title, duration and output, with the step size in force [s] in
/// place of the one asked for, with the formulation, and with the contents of meshes in place of
/// their files' names.
std::string make_identity(const Scenario& scenario, Formulation formulation, double step_size);

/// Returns the first difference of two identities in words: `blades.1.length is 8.0 in the saved
/// state and 7.5 here`. Empty if they are equal. `saved` may be any text.
std::string find_difference(const std::string& saved, const std::string& here);

}  // namespace spoke
