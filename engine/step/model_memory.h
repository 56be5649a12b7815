#pragma once

// The memory that a model takes, and whether this machine has it.

#include "engine/bodies/table/step_data.h"
#include "engine/formulation.h"

namespace spoke {

/// Estimates the memory of data and step graph of a model, by measurements of models of many sizes
/// [bytes].
template <class World>
double estimate_model_memory(const System<World>& system, Formulation formulation);

/// Throws InputError if the data and step graph of a model need more memory than four fifths of
/// what this process may use, naming both.
template <class World>
void require_memory(const System<World>& system, Formulation formulation);

}  // namespace spoke
