#pragma once

// The state of a simulation as a value.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace spoke {

/// A state of a simulation between two steps, made by Simulation::save() or read from a checkpoint.
/// It may be copied, kept and handed to other threads; it does not refer to a simulation.
struct SavedState {
  /// All that determines how a state goes on, as JSON: model, formulation, method and step size;
  /// but not executor, threads, window, duration, limits, title, output and sensors.
  std::shared_ptr<const std::string> model;
  double time = 0.0;             ///< [s]
  std::int64_t steps = 0;        ///< made since t = 0
  std::int64_t evaluations = 0;  ///< of the accelerations, so far
  double work = 0.0;             ///< by drive and loads since t = 0 [J]
  double dissipated = 0.0;       ///< since t = 0 [J]
  /// Values that a step leaves to the next, see engine/bodies/table/state_values.h, then the
  /// Observations of all steps so far (engine/simulation/observations.h).
  std::vector<double> values;
};

}  // namespace spoke
