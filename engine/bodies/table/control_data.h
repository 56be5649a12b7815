#pragma once

// The state of a controller in the table. Each subsystem that it moves joints of has one of its
// own, so that subsystems do not wait for one another; all of them are equal.

#include <array>

namespace spoke {

/// State of a PitchControl: its demands are the control points of a cubic spline, which the pitch
/// angle follows (engine/bodies/kernels/pitch_control.h).
struct ControlState {
  double speed = 0.0;               ///< filtered speed [rad/s]
  double integral = 0.0;            ///< integral part of the demand [rad]
  std::array<double, 4> demands{};  ///< of the last samples, the newest one last [rad]
  double since = 0.0;               ///< time of the newest sample [s]
  double period = 1.0;              ///< time between samples [s]
  double held = 0.0;                ///< 1: an event demands the angle, no controller does
};

}  // namespace spoke
