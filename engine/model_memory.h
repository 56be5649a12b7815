#pragma once

#include "engine/formulation/formulation.h"
#include "engine/step_data.h"

namespace spoke {

/// Throws InputError if the data and step graph of a model need more memory than four fifths of
/// what this process may use, naming both.
void demand_memory(const System& system, Formulation formulation);

}  // namespace spoke
