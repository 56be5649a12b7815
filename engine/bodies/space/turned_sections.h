#pragma once

// What sections that turn take off a body's inertia. A vector of a section becomes, to second order
// in the section's rotation th, e_a + th x e_a + 1/2 th x (th x e_a); slots have it without the
// last term, which makes T less by
//   1/2 w^T Lambda w = 1/2 th^T M th,     M = tr(P W0) 1 - 1/2 (W0 P + P W0)
// with W0 = |w|^2 1 - w w^T and the second moment P of the section: P_22, P_23 and P_33 along the
// element's axes, each over the rotations of both nodes, which are linear in between. Of a twist it
// is the propeller moment, of bending the part of rotary inertia that holds a shaft straight.

#include <array>

#include "models/space/space.h"

namespace spoke::space {

/// Rotations of both nodes about the element's axes, or forces on them. A Pair holds the values at
/// the inner and the outer node, of one element or of several.
template <class Pair>
struct Turn {
  Pair x, y, z;
};

/// Entries of W0 that count.
struct SpinWeights {
  double w22, w33, w12, w13, w23;

  explicit SpinWeights(const Angular& w)
      : w22(w[0] * w[0] + w[2] * w[2]),
        w33(w[0] * w[0] + w[1] * w[1]),
        w12(-w[0] * w[1]),
        w13(-w[0] * w[2]),
        w23(-w[1] * w[2]) {}
};

/// Forms of the rotations that make up Lambda, by P_22, P_33 and P_23.
template <class Sum>
struct TurnForms {
  std::array<Sum, 3> of_22{}, of_33{};
  std::array<Sum, 4> of_23{};

  /// Returns Lambda along the element's axes; `total`: of a Sum.
  template <class Total>
  Matrix3 inertia(Total&& total) const {
    std::array<double, 3> a, b;
    std::array<double, 4> c;
    for (std::size_t i = 0; i < 3; ++i) a[i] = total(of_22[i]);
    for (std::size_t i = 0; i < 3; ++i) b[i] = total(of_33[i]);
    for (std::size_t i = 0; i < 4; ++i) c[i] = total(of_23[i]);
    const double xy = 0.5 * (a[1] + c[1]), xz = 0.5 * (b[1] + c[2]);
    const double yz = 0.5 * (a[2] + b[2]) - c[3];
    Matrix3 inertia;
    inertia << a[0] + b[0] - 2.0 * c[0], xy, xz, xy, b[0] - c[0], yz, xz, yz, a[0] - c[0];
    return inertia;
  }
};

// K: the products of P_ab with rotations th; f: forces M th; add_forms() adds products of K with th
// or, at half of what they change by, with rates. `dot`: of two Pairs.

template <class Pair>
[[gnu::always_inline]] inline void add_forces_22(const SpinWeights& W, const Turn<Pair>& K,
                                                 Turn<Pair>& f) {
  f.x += W.w22 * K.x - 0.5 * W.w12 * K.y;
  f.y -= 0.5 * W.w12 * K.x + 0.5 * W.w23 * K.z;
  f.z += W.w22 * K.z - 0.5 * W.w23 * K.y;
}
template <class Pair>
[[gnu::always_inline]] inline void add_forces_33(const SpinWeights& W, const Turn<Pair>& K,
                                                 Turn<Pair>& f) {
  f.x += W.w33 * K.x - 0.5 * W.w13 * K.z;
  f.y += W.w33 * K.y - 0.5 * W.w23 * K.z;
  f.z -= 0.5 * W.w13 * K.x + 0.5 * W.w23 * K.y;
}
template <class Pair>
[[gnu::always_inline]] inline void add_forces_23(const SpinWeights& W, const Turn<Pair>& K,
                                                 Turn<Pair>& f) {
  const double across = 0.5 * (W.w22 + W.w33);
  f.x += 2.0 * W.w23 * K.x - 0.5 * W.w13 * K.y - 0.5 * W.w12 * K.z;
  f.y += W.w23 * K.y - 0.5 * W.w13 * K.x - across * K.z;
  f.z += W.w23 * K.z - 0.5 * W.w12 * K.x - across * K.y;
}

template <class Pair, class Dot, class Sum>
[[gnu::always_inline]] inline void add_forms_22(const Turn<Pair>& K, const Turn<Pair>& v,
                                                const Dot& dot, std::array<Sum, 3>& sums) {
  sums[0] += dot(K.x, v.x) + dot(K.z, v.z);
  sums[1] += 0.5 * (dot(K.y, v.x) + dot(K.x, v.y));
  sums[2] += 0.5 * (dot(K.y, v.z) + dot(K.z, v.y));
}
template <class Pair, class Dot, class Sum>
[[gnu::always_inline]] inline void add_forms_33(const Turn<Pair>& K, const Turn<Pair>& v,
                                                const Dot& dot, std::array<Sum, 3>& sums) {
  sums[0] += dot(K.x, v.x) + dot(K.y, v.y);
  sums[1] += 0.5 * (dot(K.x, v.z) + dot(K.z, v.x));
  sums[2] += 0.5 * (dot(K.y, v.z) + dot(K.z, v.y));
}
template <class Pair, class Dot, class Sum>
[[gnu::always_inline]] inline void add_forms_23(const Turn<Pair>& K, const Turn<Pair>& v,
                                                const Dot& dot, std::array<Sum, 4>& sums) {
  sums[0] += 0.5 * (dot(K.y, v.z) + dot(K.z, v.y));
  sums[1] += 0.5 * (dot(K.x, v.z) + dot(K.z, v.x));
  sums[2] += 0.5 * (dot(K.x, v.y) + dot(K.y, v.x));
  sums[3] += dot(K.x, v.x) + 0.5 * (dot(K.y, v.y) + dot(K.z, v.z));
}

}  // namespace spoke::space
