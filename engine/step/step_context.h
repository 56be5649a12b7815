#pragma once

// The context of a step graph: all data that its nodes work on.

#include <limits>
#include <memory>
#include <span>

#include "engine/bodies/table/step_data.h"
#include "engine/step/formulation/work.h"
#include "engine/step/integrator/step_control.h"
#include "engine/step/loops/loop_freedoms.h"
#include "engine/step/sharing.h"
#include "graph/step_graph.h"

namespace spoke {

/// The context of a simulation's steps, whatever the world.
class StepContext {
 public:
  StepContext() = default;
  StepContext(const StepContext&) = delete;
  StepContext& operator=(const StepContext&) = delete;

  Formulation formulation = Formulation::structured;
  Integrator integrator;
  double linear_range = std::numeric_limits<double>::infinity();  ///< see TableOptions
  bool loads_tie_subsystems = false;                              ///< see StepTable::is_coupled

  LoopLimits loop_limits;
  LoopStart loop_start;  ///< what start_loops() has found

  /// None unless several processes simulate the model together, see share_out().
  std::unique_ptr<Sharing> sharing;

  virtual StepTable& table() = 0;
  /// Builds the step graph of `passes` passes over the own subsystems, see build_step_graph().
  virtual graph::StepGraph build_graph(int passes) = 0;
  /// Builds the graph of one pass over all subsystems, which tells other processes nothing.
  virtual graph::StepGraph build_whole_graph() = 0;

  // Functions for shared subsystems. All processes call them at once, between runs.
  /// Returns the progress of the own subsystems; of all where they are not shared out.
  std::span<const StepProgress> own_progress();
  /// Lets all processes know the results of the window's steps, the progress among them, when all
  /// own subsystems have come to its end. Returns whether any process asks to stop.
  virtual bool share_window(bool asks_to_stop) = 0;

 protected:
  ~StepContext() = default;
};

/// The context of a step graph: the data that its nodes work on. Must outlive the graph and stay in
/// place.
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
