#pragma once

// A controller from outside the scenario, and when it is called. It is called between two steps, on
// the thread that makes them, and no node of the step graph calls it: libraries may keep data by
// thread, and objects in Python need the interpreter. What it demands is put into the states that
// controlled joints follow, and into the drive, before the step that begins there.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/controller.h"
#include "engine/saved_state.h"
#include "engine/simulation/control_record.h"
#include "engine/simulation/simulated_model.h"

namespace spoke {

/// The drive that a sample demands.
struct DemandedDrive {
  Drive drive;
  bool jumps = false;  ///< whether its torque does not go on from that in force
};

/// The controller of a simulation, and what it demands.
class ControlLoop {
 public:
  /// `model`: in space, allocated; that of `scenario`, which has an OuterControl.
  ControlLoop(const Scenario& scenario, double step_size, std::shared_ptr<Controller> controller,
              SimulatedModel& model);

  /// Whether it is time for a sample at the end of step `step`, which was not taken yet.
  bool is_due(std::int64_t step) const { return step % every_ == 0 && step != sampled_; }
  /// Calls the controller there, where the simulation stands: `sensors` are those of that time.
  /// Puts the angles that it demands into `model`, and returns its drive.
  DemandedDrive sample(std::int64_t step, const Scenario& scenario, std::span<const double> sensors,
                       SimulatedModel& model);
  /// Returns the step at whose end the next sample is, after step `step`.
  std::int64_t next(std::int64_t step) const { return (step / every_ + 1) * every_; }

  /// Returns what a saved state holds of it. Throws InputError if the controller gives nothing.
  SavedControl save() const;
  /// Goes to a state saved after `steps` steps. Throws InputError, and changes nothing, if there is
  /// none of it.
  void restore(const std::optional<SavedControl>& saved, std::int64_t steps);
  /// Returns the drive that the newest sample demands.
  Drive make_drive() const;
  /// Returns a copy for a simulation of a copy of the scenario. Throws InputError if the controller
  /// gives none.
  std::unique_ptr<ControlLoop> clone(const Scenario& scenario) const;
  const std::shared_ptr<Controller>& controller() const { return controller_; }

 private:
  void require_possible(const ControlCommands& commands, double t, std::int64_t step) const;
  void put_angles(double t, SimulatedModel& model);

  const OuterControl* place_;  ///< of the scenario
  double step_size_;
  std::int64_t every_;  ///< steps between samples
  double period_;       ///< [s]
  std::shared_ptr<Controller> controller_;
  ControlMeasurement measurement_;
  Drive own_drive_;  ///< of the scenario
  ControlCommands commands_;
  double torque_before_ = 0.0;  ///< from which commands_.torque is reached
  double yaw_ = 0.0;            ///< the newest angle that is demanded [rad]
  std::int64_t sampled_ = -1;   ///< step of the newest sample; -1: none yet
};

/// Makes the controller loop of a simulation; null if its scenario has none. `given`: the
/// program's; may be null. Throws InputError.
std::unique_ptr<ControlLoop> make_control_loop(const Scenario& scenario, double step_size,
                                               std::shared_ptr<Controller> given,
                                               SimulatedModel& model);

}  // namespace spoke
