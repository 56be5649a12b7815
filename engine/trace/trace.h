#pragma once

// A trace with all that its files say of it.

#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/support/machine.h"

namespace spoke::trace {

/// Traced steps and all that a reader needs to know of them.
struct Trace {
  StepTrace steps;
  std::string scenario;  ///< its name
  std::string title;
  SimulationOptions options;
  std::string threads;  ///< that the steps ran on: "2", "3x2"
  IntegrationMethod integrator = IntegrationMethod::generalized_alpha;
  double step_size = 0.0;  ///< [s]
  Machine machine;
  double load = -1.0;   ///< runnable processes, mean over the last minute; -1: not known
  Capacity capacity;    ///< now
  std::string created;  ///< now, UTC: "2026-11-21T15:00:00Z"
  /// What else a reader should know of how the steps were made, a sentence each.
  std::vector<std::string> notes;
};

/// What `simulation` was asked for and `steps`, which it has made.
Trace describe(const Simulation& simulation, StepTrace steps);

/// The step in the middle, of which single edges are shown. Precondition: there is one.
const TracedStep& middle_step(const StepTrace& steps);

/// "main", "worker 1", ...
std::string name_of_thread(int thread);

}  // namespace spoke::trace
