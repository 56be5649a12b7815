#pragma once

// Memory of a formulation besides the table: constants and workspaces.

#include <map>
#include <memory>

#include "engine/bodies/kernels/body_memory.h"
#include "engine/formulation.h"
#include "engine/step/formulation/augmented.h"
#include "engine/step/formulation/structured.h"
#include "engine/step/formulation/subsystem.h"

namespace spoke {

/// Constant blocks of the dense formulations, shared by bodies of one type.
template <class World>
using DenseConstants = std::map<const typename World::Body*, subsystem::DenseBlocks>;

/// Memory of the chosen formulation and of its bodies besides the table; that of the other
/// formulations stays empty.
template <class World>
struct FormulationWork {
  BodyMemory<World> bodies;
  std::shared_ptr<DenseConstants<World>> dense = std::make_shared<DenseConstants<World>>();
  std::vector<structured::SubsystemWork<World>> structured;
  std::vector<subsystem::SubsystemWork<World>> subsystem;
  augmented::Work augmented;
};

/// Makes the constants that `work` has not yet, and allocates the work of one formulation for
/// `data`.
template <class World>
void allocate(const System<World>& system, Formulation formulation, const ElasticShares& implicit,
              StepData<World>& data, FormulationWork<World>& work);

/// Estimates the memory that a formulation will need for this system [bytes], before anything is
/// allocated.
template <class World>
double estimate_memory(const System<World>& system, Formulation formulation);

}  // namespace spoke
