#pragma once

#include "engine/formulation/work.h"
#include "engine/integrator/method.h"
#include "engine/step_data.h"

namespace spoke {

/// What the nodes of a step graph work on. Must outlive the graph and stay in place.
struct StepContext {
  StepContext() = default;
  StepContext(const StepContext&) = delete;
  StepContext& operator=(const StepContext&) = delete;

  System system;
  Formulation formulation = Formulation::structured;
  Method method;
  StepData data;
  FormulationWork work;
};

/// Allocates table and work for context.system, formulation and method, undeformed; the hub turns
/// at its initial speed.
void allocate(StepContext& context);

}  // namespace spoke
