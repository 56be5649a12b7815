#pragma once

// Random vectors, rotations and matrices of space.

#include <random>

#include "models/space/space.h"

namespace spoke::space::testing {

inline double random_number(std::mt19937& random) {
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

inline Position random_vector(std::mt19937& random) {
  const double x = random_number(random), y = random_number(random);
  return {x, y, random_number(random)};
}

inline Position random_axis(std::mt19937& random) { return random_vector(random).normalized(); }

inline Twist random_twist(std::mt19937& random) {
  const Position translation = random_vector(random);
  return make_twist(translation, random_vector(random));
}

inline Rotation random_rotation(std::mt19937& random) {
  return exponential(3.0 * random_vector(random));
}

inline TwistMatrix random_matrix(std::mt19937& random) {
  TwistMatrix m;
  for (int c = 0; c < kTwist; ++c) m.col(c) = random_twist(random);
  return m;
}

/// Draws a positive definite matrix, of condition up to some thousand.
inline SymmetricTwistMatrix random_inertia(std::mt19937& random) {
  const TwistMatrix a = random_matrix(random);
  const TwistMatrix m = a * a.transpose() + 0.01 * TwistMatrix::Identity();
  return SymmetricTwistMatrix::from_matrix(m);
}

}  // namespace spoke::space::testing
