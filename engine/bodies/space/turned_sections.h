#pragma once

// What sections and small masses that turn take off a body's inertia. A vector of a section
// becomes, to second order in the section's rotation th, e_a + th x e_a + 1/2 th x (th x e_a);
// slots have it without the last term, which makes T less by
//   1/2 w^T Lambda w = 1/2 th^T M th,     M = tr(P W0) 1 - 1/2 (W0 P + P W0)
// with W0 = |w|^2 1 - w w^T and the second moment P, in any axes of the body. The rotation is
// linear between the nodes of an element, as that of slots is: what a round shaft twists has the
// same inertia at any speed. Of a twist it is the propeller moment, of bending the part of rotary
// inertia that holds a shaft straight.

#include <vector>

#include "models/space/beam_element.h"

namespace spoke::space {

/// Lambda [kg m^2] in B of a rotation by node, and its bilinear form in that and its rate.
struct TurnedInertia {
  Matrix3 value = Matrix3::Zero();
  Matrix3 rate = Matrix3::Zero();  ///< half of what Lambda changes by [kg m^2/s]
};

/// The second moments that an element turns: of its sections, and of small masses. All in B.
struct TurnedMasses {
  const Matrix3& sections;
  const std::vector<PointInertia>& points;
};

/// Returns M th.
[[gnu::always_inline]] inline Position turned_moment(const Matrix3& P, const Angular& w,
                                                     const Position& th) {
  const double square = w.squaredNorm();
  const auto W0 = [&](const Position& x) __attribute__((always_inline)) {
    return Position(square * x - w.dot(x) * w);
  };
  const double trace = square * P.trace() - w.dot(P.lazyProduct(w));
  return trace * th - 0.5 * (W0(P.lazyProduct(th)) + P.lazyProduct(W0(th)));
}

/// Returns Lambda of a second moment P [kg m^2] that turns by a [rad], or its bilinear form in a
/// and b.
[[gnu::always_inline]] inline Matrix3 turned_inertia(const Matrix3& P, const Position& a,
                                                     const Position& b) {
  const Position P_a = P.lazyProduct(a), P_b = P.lazyProduct(b);
  const Matrix3 half = a * P_b.transpose() + b * P_a.transpose();
  Matrix3 inertia = 0.25 * (half + half.transpose()) - a.dot(b) * P;
  inertia.diagonal().array() += a.dot(b) * P.trace() - a.dot(P_b);
  return inertia;
}

/// The rotations of an element's sections, linear between its nodes, by two of which the squares
/// sum up to the mean square: that in the middle, and what is added to it, by 1/sqrt(12).
struct SectionTurns {
  Position mean, slope;

  /// q: values by node.
  [[gnu::always_inline]] explicit SectionTurns(const double* q) {
    using Rotations = Eigen::Map<const Position>;
    const Rotations inner(q + kRotation), outer(q + kTwist + kRotation);
    mean = 0.5 * (inner + outer);
    slope = kSlope * (outer - inner);
  }

  static constexpr double kSlope = 0.28867513459481287;  // 1/sqrt(12)
};

/// As turned_inertia() of both parts of the rotations.
[[gnu::always_inline]] inline Matrix3 turned_inertia(const Matrix3& P, const SectionTurns& a,
                                                     const SectionTurns& b) {
  const Position P_mean = P.lazyProduct(b.mean), P_slope = P.lazyProduct(b.slope);
  const Matrix3 half = a.mean * P_mean.transpose() + a.slope * P_slope.transpose() +
                       P.lazyProduct(a.mean) * b.mean.transpose() +
                       P.lazyProduct(a.slope) * b.slope.transpose();
  const double product = a.mean.dot(b.mean) + a.slope.dot(b.slope);
  Matrix3 inertia = 0.25 * (half + half.transpose()) - product * P;
  inertia.diagonal().array() += product * P.trace() - a.mean.dot(P_mean) - a.slope.dot(P_slope);
  return inertia;
}

/// Subtracts the forces M th of an element at an angular velocity w from `force`, and adds its
/// forms to the sum. q, v, force: by node, from the inner one on.
[[gnu::always_inline]] inline void subtract_turned(const TurnedMasses& masses, const Angular& w,
                                                   const double* q, const double* v, double* force,
                                                   TurnedInertia& sum) {
  const SectionTurns th(q), rate(v);
  sum.value += turned_inertia(masses.sections, th, th);
  sum.rate += turned_inertia(masses.sections, th, rate);
  const Position half = 0.5 * turned_moment(masses.sections, w, th.mean);
  const Position apart = SectionTurns::kSlope * turned_moment(masses.sections, w, th.slope);
  Eigen::Map<Position>(force + kRotation) -= half - apart;
  Eigen::Map<Position>(force + kTwist + kRotation) -= half + apart;
  using Coordinates = Eigen::Matrix<double, 2 * kTwist, 1>;
  using ConstCoordinates = Eigen::Map<const Coordinates>;
  for (const PointInertia& point : masses.points) {
    const Position th_p = point.rotation.lazyProduct(ConstCoordinates(q));
    sum.value += turned_inertia(point.second, th_p, th_p);
    sum.rate += turned_inertia(point.second, th_p,
                               Position(point.rotation.lazyProduct(ConstCoordinates(v))));
    const Position moment = turned_moment(point.second, w, th_p);
    Eigen::Map<Coordinates>(force, 2 * kTwist) -= point.rotation.transpose().lazyProduct(moment);
  }
}

/// Adds Lambda of an element alone, to the bits of subtract_turned().
[[gnu::always_inline]] inline void add_turned(const TurnedMasses& masses, const double* q,
                                              Matrix3& sum) {
  const SectionTurns turns(q);
  sum += turned_inertia(masses.sections, turns, turns);
  for (const PointInertia& point : masses.points) {
    const Position th =
        point.rotation.lazyProduct(Eigen::Map<const Eigen::Matrix<double, 2 * kTwist, 1>>(q));
    sum += turned_inertia(point.second, th, th);
  }
}

}  // namespace spoke::space
