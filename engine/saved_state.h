#pragma once

// The state of a simulation as a value.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spoke {

/// What a saved state holds of a controller of the program's (engine/controller.h).
struct SavedControl {
  std::int64_t sampled = -1;     ///< step at whose end it took its newest sample; -1: none yet
  std::vector<double> commands;  ///< see ControlLoop::save() of engine/simulation/control_loop.cpp
  std::string memory;            ///< what Controller::save() has returned
};

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
  std::optional<SavedControl> control{};  ///< where there is a controller of the program's
};

}  // namespace spoke
