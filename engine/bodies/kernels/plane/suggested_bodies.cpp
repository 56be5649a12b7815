// Counts bodies up until the largest deflection would do.

#include "engine/bodies/kernels/plane/suggested_bodies.h"

#include <cassert>

namespace spoke::plane {

int suggest_bodies(int bodies, double ratio, double limit) {
  assert(bodies > 0 && limit > 0.0);
  constexpr int kMost = 100000;
  // Returns the deflection of the first of n bodies under a curvature that falls as (1 - x/L)^2, by
  // its length.
  const auto share = [](double n) { return (1.0 - (2.0 / 3.0 - 1.0 / (6.0 * n)) / n) / n; };
  int n = bodies;
  while (n < kMost && ratio * share(n) > limit * share(bodies)) ++n;
  return n;
}

}  // namespace spoke::plane
