#pragma once

// Events of a scenario in a run (docs/scenario.md, [[event]]): when they act, and what they do to
// the drive and to the joints that controllers move. They are looked at between two steps, as
// controllers from outside are, by the thread that makes the steps: hence the same on all
// executors.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/simulation/simulated_model.h"
#include "models/event.h"

namespace spoke {

/// The events of a simulation, and what is in force by them.
class Events {
 public:
  /// `model`: in space, allocated; that of `scenario`. Throws InputError if a condition names no
  /// sensor.
  Events(const Scenario& scenario, double step_size, SimulatedModel& model);

  /// Whether the end of step `step` was not looked at yet.
  bool is_due(std::int64_t step) const { return step != taken_; }
  /// Whether a condition waits for a sensor.
  bool reads_sensors() const;
  /// Looks at the end of step `step`, where the simulation stands: lets events act on the joints of
  /// `model`, and moves those that events move. `sensors`: of that time, if reads_sensors().
  /// Returns whether the drive is another one now.
  bool take(std::int64_t step, std::span<const double> sensors, SimulatedModel& model);
  /// Returns the step at whose end it has to look next, after step `step`.
  std::int64_t next(std::int64_t step, SimulatedModel& model) const;

  bool stops_controller() const { return stops_controller_; }
  /// The drive of the first rotor that scenario, controller or program have put in force.
  const Drive& own_drive() const { return own_drive_; }
  void set_own_drive(const Drive& drive) { own_drive_ = drive; }
  /// Returns what events leave of a drive.
  Drive act_on(const Drive& drive) const;

  std::vector<EventInRun> in_run() const;

  /// What a saved state holds of them: so many numbers.
  std::size_t count_saved() const { return 1 + 2 * events_.size(); }
  void save(std::vector<double>& values) const;
  /// Whether numbers of a state after `steps` steps can be what was saved.
  bool is_possible(std::span<const double> saved, std::int64_t steps) const;
  /// Goes to what was saved. Precondition: is_possible().
  void restore(std::span<const double> saved);

 private:
  /// An event, and how far it is.
  struct Course {
    Event event;
    std::optional<EventCondition> condition{};
    std::size_t sensor = 0;     ///< of the condition
    std::int64_t at = 0;        ///< step at whose end its time has come
    std::int64_t delay = 0;     ///< [steps]
    std::int64_t noticed = -1;  ///< step at whose end its condition held first; -1: none yet
    std::int64_t acted = -1;    ///< step at whose end it acted; -1: none yet
    std::vector<std::size_t> pitched{};  ///< subsystems whose blades it turns
  };
  /// What an event demands of a subsystem.
  struct Hold {
    bool is_held = false;
    bool is_new = false;         ///< whether it begins where the simulation stands
    std::optional<double> to{};  ///< [rad]; none: its joints stop
    double rate = 0.0;           ///< [rad/s]
  };

  void act(const Course& course);
  void hold(const EventTurn& turn, const std::vector<std::size_t>& subsystems);
  void move(const Hold& hold, double t, ControlState& state) const;
  std::int64_t next_demand(const ControlState& state) const;

  double step_size_;
  double period_;  ///< between demands on joints [s]
  std::vector<Course> events_;
  std::vector<std::size_t> pitched_;  ///< subsystems whose blades are pitched
  std::vector<std::size_t> yawed_;    ///< the support, if it is yawed
  Drive own_drive_;

  std::int64_t taken_ = -1;  ///< step at whose end it looked last; -1: none
  std::vector<Hold> holds_;  ///< by subsystem
  bool stops_controller_ = false;
  bool generator_is_off_ = false;
  Brake brake_{};
};

/// Makes the events of a simulation; null if its scenario has none. Throws InputError.
std::unique_ptr<Events> make_events(const Scenario& scenario, double step_size,
                                    SimulatedModel& model);

}  // namespace spoke
