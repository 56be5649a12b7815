#pragma once

// Lowest and highest frequency of a model in space, and the step that they allow rk4.

#include <complex>

#include "models/scenario.h"

namespace spoke::vibration {

/// The largest step at which rk4 is stable, and the small motion that sets it.
struct Rk4Limit {
  double step = 0.0;          ///< [s]; infinite where nothing vibrates
  double speed = 0.0;         ///< of the hub in that motion [rad/s]
  std::complex<double> root;  ///< of the motion [1/s]
};

/// Limits of a model in space.
struct FrequencyLimits {
  /// Natural frequencies at rest, undeformed, without damping, loads and gravity [rad/s]; 0 if
  /// there is none. Motions that nothing holds do not count.
  double lowest = 0.0;
  double highest = 0.0;
  Rk4Limit rk4;
};

/// Finds the limits from the model linearised about its undeformed state, with joints where they
/// start: at rest; and with damping, drag and loads both at rest and at the largest speed that the
/// drive prescribes or starts with, of which the one with the smaller step of rk4 counts.
/// Equilibria hardly change the stiffest motions. Stops count where they are touched; loads of the
/// program's own do not count. Throws InputError if a subsystem has too many coordinates, or all
/// subsystems together.
FrequencyLimits find_frequency_limits(const Scenario& scenario);

/// Returns only the limit of rk4.
Rk4Limit find_rk4_limit(const Scenario& scenario);

}  // namespace spoke::vibration
