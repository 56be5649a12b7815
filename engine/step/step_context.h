#pragma once

// All that the nodes of a step graph work on.

#include <limits>

#include "engine/formulation/work.h"
#include "engine/integrator/step_control.h"
#include "engine/table/step_data.h"

namespace spoke {

/// What the nodes of a step graph work on. Must outlive the graph and stay in place.
struct StepContext {
  StepContext() = default;
  StepContext(const StepContext&) = delete;
  StepContext& operator=(const StepContext&) = delete;

  System system;
  Formulation formulation = Formulation::structured;
  Integrator integrator;
  double linear_range = std::numeric_limits<double>::infinity();  ///< see TableOptions
  bool loads_tie_blades = false;                                  ///< see StepData::is_coupled
  StepData data;
  FormulationWork work;
};

/// Allocates table and work for context.system, formulation and integrator, undeformed; the hub
/// turns at its initial speed. `window_steps`: see TableOptions.
void allocate(StepContext& context, int window_steps = 1);

}  // namespace spoke
