#pragma once

// Between which frequencies a model in space vibrates, and the step that they allow rk4.

#include <complex>

#include "models/scenario.h"

namespace spoke::vibration {

/// The largest step at which rk4 is stable, and the small motion that sets it.
struct Rk4Limit {
  double step = 0.0;          ///< [s]; infinite where nothing vibrates
  double speed = 0.0;         ///< of the hub in that motion [rad/s]
  std::complex<double> root;  ///< of the motion [1/s]
};

/// Of a model in space.
struct FrequencyLimits {
  /// Natural frequencies at rest, undeformed, without damping, loads and gravity [rad/s]; 0 if
  /// there is none. Motions that nothing holds do not count.
  double lowest = 0.0;
  double highest = 0.0;
  Rk4Limit rk4;
};

/// Finds them from the model linearised about its undeformed state, the joints where they start: at
/// rest, and with damping, drag and loads at rest and at the largest speed that the drive
/// prescribes or starts with, whichever allows rk4 the smaller step. Equilibria move the stiffest
/// motions by next to nothing. Stops count where they are touched, and loads of the program's own
/// not. Throws InputError if a tree has too many coordinates, or all trees together.
FrequencyLimits find_frequency_limits(const Scenario& scenario);

/// The last of these alone.
Rk4Limit find_rk4_limit(const Scenario& scenario);

}  // namespace spoke::vibration
