// Counts bodies up until the largest deflection would do.

#include "engine/kernels/suggested_bodies.h"

namespace spoke {

int suggest_bodies(int bodies, double ratio, double limit) {
  constexpr int kMost = 100000;
  // Deflection of the first of n bodies under a curvature that falls as (1 - x/L)^2, by its length.
  const auto share = [](double n) { return (1.0 - (2.0 / 3.0 - 1.0 / (6.0 * n)) / n) / n; };
  int n = bodies;
  while (n < kMost && ratio * share(n) > limit * share(bodies)) ++n;
  return n;
}

}  // namespace spoke
