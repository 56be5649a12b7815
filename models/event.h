#pragma once

// Events: what happens to a turbine once at a time, or when a sensor passes a limit. They act on
// what controllers act on, too: the drive, the pitch and the yaw (docs/scenario.md, [[event]]).

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "spoke/export.h"

namespace spoke {

/// An angle that an event demands of joints, in place of what a controller demands.
struct EventTurn {
  std::optional<double> to = std::nullopt;    ///< [rad]; none: the joints stop where they are
  std::optional<double> rate = std::nullopt;  ///< at which the demand goes there [rad/s]
  /// Numbers of the blades, from 1, subsystems on hubs behind blades; empty: all that a controller
  /// moves. Of pitch alone.
  std::vector<int> blades{};
};

/// Something that happens once, at the end of the first step at which its condition holds.
struct Event {
  std::string name{};                       ///< empty: "event 2", by its place in the list
  std::optional<double> at = std::nullopt;  ///< time [s]; else `when`
  std::string when{};                       ///< a comparison of a sensor: "hub.speed > 1.4"
  double delay = 0.0;  ///< from the end of the step at which it holds to the actions [s]

  bool generator_off = false;  ///< the drive has no torque from then on
  double brake = 0.0;          ///< torque of a shaft brake, on the hub's side [N m]
  double brake_speed = 0.01;   ///< from which on it has that torque [rad/s]
  bool controller_off = false;
  std::optional<EventTurn> pitch = std::nullopt;
  std::optional<EventTurn> yaw = std::nullopt;
};

/// The condition of Event::when.
struct EventCondition {
  std::string sensor{};  ///< name of a column of sensors.csv
  bool is_above = true;  ///< whether the sensor is to be greater than the limit, else less
  double limit = 0.0;    ///< in the unit of the sensor

  bool holds(double value) const { return is_above ? value > limit : value < limit; }
};

/// Reads a condition, "hub.speed > 1.4" or with "<"; none if it is not one.
SPOKE_EXPORT std::optional<EventCondition> parse_condition(const std::string& when);

/// Returns the name of an event by its index in the list.
SPOKE_EXPORT std::string name_of_event(const Event& event, std::size_t index);

/// An event of a scenario in a run.
struct EventInRun {
  std::string name{};
  std::optional<double> time = std::nullopt;  ///< at which it acted [s]; none: it did not yet
};

}  // namespace spoke
