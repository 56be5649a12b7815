#pragma once

// Options of a simulation, size of its model, and observers of its steps.

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "engine/controller.h"
#include "engine/exchange.h"
#include "engine/formulation.h"
#include "graph/executor.h"

namespace spoke {

using graph::ExecutorKind;
using graph::name_of;

/// The widest window of steps that may be asked for.
inline constexpr int kMostWindow = 1000;

/// Options of a simulation. Only the formulation affects the results, by round-off, and a
/// controller.
struct SimulationOptions {
  Formulation formulation = Formulation::structured;  ///< of the equations of motion
  ExecutorKind executor = ExecutorKind::automatic;    ///< what runs the step graph
  graph::Threads threads{};  ///< default: the cores available to the process
  /// Number of steps that one run of the executor may make where the whole motion of the hub is
  /// prescribed: blades then need not wait for one another between steps. At most kMostWindow; 0:
  /// the executor chooses.
  int window = 0;
  /// Makes an executor that runs the steps in place of `executor` and `threads`, which then have no
  /// effect. Called by the constructor of Simulation for the graph of one pass and, if `window` is
  /// above 1, for that of a window; an exception that it throws leaves the constructor. See
  /// graph::Executor.
  graph::ExecutorFactory make_executor{};
  /// Exchange of data if several processes simulate one model together; must outlive the
  /// simulation. Each makes the steps of some of the subsystems, on as many threads as it likes.
  /// All call the functions of Simulation that make steps alike and in the same order, with an
  /// observer either all or none. Behind such a call each has the state of the whole model, with
  /// the bits that one process alone would have. Not possible with the formulation augmented, loads
  /// of the program, and traces; at most as many processes as subsystems.
  Exchange* exchange = nullptr;
  /// The controller of a scenario with [control.program], which needs one; of this simulation
  /// alone. It affects the results as the scenario does.
  std::shared_ptr<Controller> controller{};
};

/// The size of a model.
struct ModelSize {
  int subsystems = 0;   ///< blades and other subsystems
  int bodies = 0;       ///< flexible bodies (without the hub)
  int coordinates = 0;  ///< free ones of hub and joints, and all deformations
  int joints = 0;       ///< between bodies, and to the hub
  int loops = 0;        ///< closed loops
  int couplings = 0;    ///< of joints, shafts of drive trains among them
  int freedoms = 0;     ///< coordinates, less the rows of both that are rigid and not redundant
  int graph_nodes = 0;  ///< of the step graph of one pass
  int graph_edges = 0;  ///< of the same graph
  std::size_t memory_bytes = 0;  ///< of data, constants and graph, about
};

/// Called at the end of a step with its time [s] and the sensors there, in the order of
/// Simulation::sensor_names(), valid during the call.
using StepObserver = std::function<void(double t, std::span<const double> sensors)>;

}  // namespace spoke
