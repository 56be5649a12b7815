#pragma once

// What files of other programs say of a generator, of pitch and yaw, in Spoke's terms.

#include <optional>
#include <string>
#include <vector>

#include "program/foreign/value.h"

namespace spoke::foreign {

/// What brakes the hub. Without points it turns freely.
struct FoundGenerator {
  std::vector<double> speed, torque;  ///< on the hub's side [rad/s, N m], opposite to the speed
  std::string from;                   ///< what the curve is, and where it came from
};

/// An angle that goes to another one at a constant rate.
struct FoundManeuver {
  double start = 0.0, rate = 0.0, angle = 0.0;  ///< [s, rad/s, rad], rate > 0
  std::string from;
};

/// The nacelle on the tower. By default it is fixed.
struct FoundYaw {
  Value angle;                            ///< at the start, about the vertical [rad]
  bool moves = false;                     ///< whether a spring and a damper hold it
  Value stiffness, damping, rest;         ///< [N m/rad, N m s/rad, rad]
  std::optional<FoundManeuver> maneuver;  ///< only where it does not move by itself
};

/// A controller that is a library of Bladed's kind.
struct FoundLibrary {
  std::string file, input;  ///< as the program that imports finds them
  bool is_there = true;     ///< whether there is such a file; otherwise it is but a comment
  Value efficiency, period, gear_ratio, brake_torque;  ///< -, s, -, N m; without a source: defaults
  bool pitches = true, yaws = false, has_individual_pitch = false;
  std::string from;
};

}  // namespace spoke::foreign
