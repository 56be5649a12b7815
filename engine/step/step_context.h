#pragma once

// All that the nodes of a step graph work on.

#include <limits>

#include "engine/formulation/work.h"
#include "engine/integrator/step_control.h"
#include "engine/table/step_data.h"
#include "graph/step_graph.h"

namespace spoke {

/// What the steps of a simulation are made with, whatever the world.
class StepContext {
 public:
  StepContext() = default;
  StepContext(const StepContext&) = delete;
  StepContext& operator=(const StepContext&) = delete;

  Formulation formulation = Formulation::structured;
  Integrator integrator;
  double linear_range = std::numeric_limits<double>::infinity();  ///< see TableOptions
  bool loads_tie_blades = false;                                  ///< see StepTable::is_coupled

  virtual StepTable& table() = 0;
  /// The step graph of `passes` passes, see build_step_graph().
  virtual graph::StepGraph build_graph(int passes) = 0;

 protected:
  ~StepContext() = default;
};

/// What the nodes of a step graph work on. Must outlive the graph and stay in place.
template <class World>
class SystemContext final : public StepContext {
 public:
  System<World> system;
  StepData<World> data;
  FormulationWork<World> work;

  StepTable& table() override { return data; }
  graph::StepGraph build_graph(int passes) override;
};

/// Allocates table and work for context.system, formulation and integrator, undeformed; the hub
/// turns at its initial speed. `window_steps`: see TableOptions.
template <class World>
void allocate(SystemContext<World>& context, int window_steps = 1);

}  // namespace spoke
