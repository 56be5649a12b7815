#pragma once

// Whether a model fits into this machine's memory.

#include "engine/formulation/formulation.h"
#include "engine/table/step_data.h"

namespace spoke {

/// Throws InputError if the data and step graph of a model need more memory than four fifths of
/// what this process may use, naming both.
void require_memory(const System& system, Formulation formulation);

}  // namespace spoke
