#pragma once

// Products with an element's matrices and axes, in pairs of neighbouring values.

#include "models/space/beam_element.h"
#include "models/support/simd.h"

namespace spoke::space {

/// Six values in three registers.
struct Double6 {
  Double2 a{}, b{}, c{};

  [[gnu::always_inline]] void add(double factor, const double* x) {
    const Double2 f = broadcast(factor);
    a += f * load(x);
    b += f * load(x + 2);
    c += f * load(x + 4);
  }
  [[gnu::always_inline]] void store_to(double* x) const {
    store(a, x);
    store(b, x + 2);
    store(c, x + 4);
  }
};

/// Returns A x for a matrix of six columns that lie one after another.
[[gnu::always_inline]] inline Double6 multiply(const double* A, const double* x) {
  Double6 sum;
  for (int j = 0; j < kTwist; ++j) sum.add(x[j], A + kTwist * j);
  return sum;
}

/// Calculates displacement and rotation of an element's outer node as seen from the inner: d = G q.
/// `q` holds the coordinates of both nodes.
[[gnu::always_inline]] inline void calc_relative(const BeamElement& element, const double* q,
                                                 double* d) {
  const Position& c = element.chord;
  d[0] = q[6] - q[0] - (q[4] * c[2] - q[5] * c[1]);
  d[1] = q[7] - q[1] - (q[5] * c[0] - q[3] * c[2]);
  d[2] = q[8] - q[2] - (q[3] * c[1] - q[4] * c[0]);
  for (int i = 3; i < 6; ++i) d[i] = q[6 + i] - q[i];
}

/// Subtracts G^T F from the forces: the wrench F on the outer node, and its balance on the inner.
[[gnu::always_inline]] inline void subtract_wrench(const BeamElement& element, const double* F,
                                                   double* force) {
  const Position& c = element.chord;
  force[3] += F[3] + (c[1] * F[2] - c[2] * F[1]);
  force[4] += F[4] + (c[2] * F[0] - c[0] * F[2]);
  force[5] += F[5] + (c[0] * F[1] - c[1] * F[0]);
  for (int i = 0; i < 3; ++i) force[i] += F[i];
  for (int i = 0; i < 6; ++i) force[6 + i] -= F[i];
}

}  // namespace spoke::space
