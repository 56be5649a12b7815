#pragma once

// Controllers of a rotor, as data: they read the hub's speed and move joints.

#include <optional>
#include <string>
#include <vector>

#include "models/curve.h"
#include "spoke/export.h"

namespace spoke {

/// Collective pitch: a proportional-integral controller of the hub's speed with a gain schedule and
/// limits, sampled in time (docs/scenario.md, [control.pitch]). The pitch angle theta grows towards
/// feather; each joint stands at its own motion plus sign theta.
struct PitchControl {
  /// Names of the joints, of blades and of subsystems on the hub: revolute, of a motion that the
  /// scenario prescribes.
  std::vector<std::string> joints{};
  double speed = 0.0;         ///< set point; negative where the rotor turns so [rad/s]
  double proportional = 0.0;  ///< pitch angle by speed error [s]
  double integral = 0.0;      ///< pitch angle by integral of the speed error [rad/rad]
  /// Gains have the factor 1/(1 + theta/half_gain_angle) [rad].
  std::optional<double> half_gain_angle = std::nullopt;
  /// Gains have this factor, over theta in place of time [rad]. Not along with half_gain_angle.
  std::optional<Curve> schedule = std::nullopt;
  double minimum = 0.0;                       ///< of theta [rad]
  double maximum = 0.0;                       ///< of theta [rad]
  std::optional<double> rate = std::nullopt;  ///< largest rate of theta [rad/s]; none: no limit
  std::optional<double> filter =
      std::nullopt;      ///< corner frequency of the low-pass on speed [rad/s]
  double initial = 0.0;  ///< theta at t = 0 [rad]
  double sign = 1.0;     ///< joint angle by theta: 1 or -1
  /// Time between samples, in steps to the nearest whole number from 1 on [s]; none: a step.
  std::optional<double> period = std::nullopt;
};

/// Returns the factor of the gains at a pitch angle [rad].
SPOKE_EXPORT double calc_gain_factor(const PitchControl& control, double angle);

}  // namespace spoke
