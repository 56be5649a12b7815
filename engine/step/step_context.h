#pragma once

// All that the nodes of a step graph work on.

#include <limits>
#include <memory>
#include <span>

#include "engine/formulation/work.h"
#include "engine/integrator/step_control.h"
#include "engine/step/sharing.h"
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

  /// None unless several processes simulate the model together, see share_out().
  std::unique_ptr<Sharing> sharing;

  virtual StepTable& table() = 0;
  /// The step graph of `passes` passes over the own subsystems, see build_step_graph().
  virtual graph::StepGraph build_graph(int passes) = 0;
  /// Of one pass over all subsystems, which tells other processes nothing.
  virtual graph::StepGraph build_whole_graph() = 0;

  // Where subsystems are shared out. All processes call these at once, between runs.
  /// Progress of the own subsystems; of all where they are not shared out.
  std::span<const StepProgress> own_progress();
  /// When all own subsystems have come to the end of the window: lets all processes know what its
  /// steps have left, the progress among it. Whether any of them asks to stop.
  virtual bool share_window(bool asks_to_stop) = 0;

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
  graph::StepGraph build_whole_graph() override;
  bool share_window(bool asks_to_stop) override;
};

/// Allocates table and work for context.system, formulation and integrator, undeformed; the hub
/// turns at its initial speed. `window_steps`: see TableOptions.
template <class World>
void allocate(SystemContext<World>& context, int window_steps = 1);

/// Puts an allocated hub where its support and drive have it at t = 0.
template <class World>
void put_hub_at_start(SystemContext<World>& context);

}  // namespace spoke
