#pragma once

// Roots of characteristic equations, and blades at rest, for the tests of this folder.

#include "engine/bodies/kernels/plane/natural_frequencies.h"
#include "models/rotor.h"

namespace spoke::test {

/// Finds the root of `function` between `low` and `high`, at which its signs differ, by bisection.
template <class Function>
double find_root(const Function& function, double low, double high) {
  const bool is_rising = function(low) < 0.0;
  for (int k = 0; k < 200 && high - low > 1e-15 * high; ++k) {
    const double middle = 0.5 * (low + high);
    ((function(middle) < 0.0) == is_rising ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Finds the first root of `function` beyond `from`, looked for in steps.
template <class Function>
double find_next_root(const Function& function, double from, double step) {
  double low = from;
  while ((function(low) < 0.0) == (function(low + step) < 0.0)) low += step;
  return find_root(function, low, low + step);
}

/// Returns natural frequency number `number`, from 1, of a blade clamped at its root [rad/s].
inline double natural_frequency(const Blade& blade, int number) {
  Rotor rotor;
  rotor.blades = {blade};
  double high = 1.0;
  while (plane::count_frequencies_below(rotor, high) < number) high *= 2.0;
  return find_root(
      [&](double frequency) {
        return plane::count_frequencies_below(rotor, frequency) < number ? -1.0 : 1.0;
      },
      0.0, high);
}

}  // namespace spoke::test
