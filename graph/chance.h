#pragma once

#include <random>

namespace spoke::graph {

/// What varies by chance. The same numbers, in the same order, from every object and on every
/// platform.
class Chance {
 public:
  double from_0_to_1() {
    return static_cast<double>(random_() - Random::min()) / (Random::max() - Random::min());
  }
  /// From 1 - `most` to 1 + `most`.
  double factor(double most) { return 1.0 + most * (2.0 * from_0_to_1() - 1.0); }
  /// From 0 to `count` - 1.
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  using Random = std::minstd_rand;
  Random random_;
};

}  // namespace spoke::graph
