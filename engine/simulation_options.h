#pragma once

// How a simulation is run, how large its model is, and who observes its steps.

#include <cstddef>
#include <functional>
#include <span>

#include "engine/exchange.h"
#include "engine/formulation/formulation.h"
#include "graph/executor.h"

namespace spoke {

using graph::ExecutorKind;
using graph::name_of;

/// The widest window of steps that may be asked for.
inline constexpr int kMostWindow = 1000;

/// How a simulation is run. Only the formulation matters to the results, by round-off.
struct SimulationOptions {
  Formulation formulation = Formulation::structured;  ///< of the equations
  ExecutorKind executor = ExecutorKind::automatic;    ///< what runs the step graph
  graph::Threads threads{};  ///< unless set: the cores available to the process
  /// Steps that one run of the executor may make where the hub's whole motion is prescribed; there
  /// blades need not wait for one another between steps. At most kMostWindow; 0: as the executor
  /// chooses.
  int window = 0;
  /// Makes what runs the steps instead of `executor` and `threads`, which then say nothing: called
  /// by the constructor of Simulation for the graph of one pass, and, if `window` is above 1, for
  /// that of a window; what it throws leaves the constructor. See graph::Executor.
  graph::ExecutorFactory make_executor{};
  /// Where several processes simulate one model together: how they tell one another what they find;
  /// must outlive the simulation. Each makes the steps of some of the subsystems, on as many
  /// threads as it likes; all call the functions of Simulation that make steps alike and in the
  /// same order, with an observer either all or none. Behind such a call each has the state of the
  /// whole model, with the bits that one process alone would have. Not with the formulation
  /// augmented, loads of the program's, and traces; at most as many processes as subsystems.
  Exchange* exchange = nullptr;
};

/// The size of a model.
struct ModelSize {
  int subsystems = 0;   ///< blades
  int bodies = 0;       ///< flexible bodies (without the hub)
  int coordinates = 0;  ///< independent coordinates: free hub coordinates and all deformations
  int joints = 0;       ///< between bodies, and to the hub
  int graph_nodes = 0;  ///< of the step graph, one pass
  int graph_edges = 0;  ///< likewise
  std::size_t memory_bytes = 0;  ///< of data, constants and graph, about
};

/// Told of the end of a step: time [s] and the sensors there, in the order of
/// Simulation::sensor_names(), valid during the call.
using StepObserver = std::function<void(double t, std::span<const double> sensors)>;

}  // namespace spoke
