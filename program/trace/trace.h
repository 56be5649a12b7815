#pragma once

// A trace with all settings that its files mention.

#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/support/machine.h"
#include "program/trace/more_threads.h"

namespace spoke::trace {

/// Traced steps with all that a reader needs to know about them.
struct Trace {
  StepTrace steps;
  std::string scenario;  ///< its name
  std::string title;
  SimulationOptions options;
  std::string threads;  ///< threads that the steps ran on: "2", "3x2"
  IntegrationMethod integrator = IntegrationMethod::generalized_alpha;
  double step_size = 0.0;  ///< [s]
  Machine machine;
  double load = -1.0;   ///< runnable processes, mean over the last minute; -1: not known
  Capacity capacity;    ///< now
  std::string created;  ///< time of the trace in UTC: "2026-11-21T15:00:00Z"
  /// Notes on how the steps were made, a sentence each.
  std::vector<std::string> notes;
  std::optional<MoreThreads> more_threads;  ///< what they would gain, where it was asked for
};

/// Describes `steps`, which `simulation` has made, with the settings of the simulation.
Trace describe(const Simulation& simulation, StepTrace steps);

/// Returns the step in the middle, whose single edges are shown. Precondition: there is one.
const TracedStep& middle_step(const StepTrace& steps);

/// Returns "main", "worker 1", ...
std::string name_of_thread(int thread);

}  // namespace spoke::trace
