#pragma once

// What sections and small masses that turn take off a body's inertia. A vector of a section
// becomes, to second order in the section's rotation th, e_a + th x e_a + 1/2 th x (th x e_a);
// slots have it without the last term, which makes T less by
//   1/2 w^T Lambda w = 1/2 th^T M th,     M = tr(P W0) 1 - 1/2 (W0 P + P W0)
// with W0 = |w|^2 1 - w w^T and the second moment P, in any axes of the body. The sections of an
// element take the mean of the rotations of both its nodes. Of a twist it is the propeller moment,
// of bending the part of rotary inertia that holds a shaft straight.

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

/// Returns the mean of the rotations of an element's nodes, of values by node.
[[gnu::always_inline]] inline Position mean_rotation(const double* q) {
  using Rotations = Eigen::Map<const Position>;
  return 0.5 * (Rotations(q + kRotation) + Rotations(q + kTwist + kRotation));
}

/// Subtracts the forces M th of an element at an angular velocity w from `force`, and adds its
/// forms to the sum. q, v, force: by node, from the inner one on.
[[gnu::always_inline]] inline void subtract_turned(const TurnedMasses& masses, const Angular& w,
                                                   const double* q, const double* v, double* force,
                                                   TurnedInertia& sum) {
  const auto add = [&](const Matrix3& P, const Position& th, const Position& rate)
      __attribute__((always_inline)) {
    sum.value += turned_inertia(P, th, th);
    sum.rate += turned_inertia(P, th, rate);
    return turned_moment(P, w, th);
  };
  const Position half = 0.5 * add(masses.sections, mean_rotation(q), mean_rotation(v));
  Eigen::Map<Position>(force + kRotation) -= half;
  Eigen::Map<Position>(force + kTwist + kRotation) -= half;
  using Coordinates = Eigen::Matrix<double, 2 * kTwist, 1>;
  using ConstCoordinates = Eigen::Map<const Coordinates>;
  for (const PointInertia& point : masses.points) {
    const Position moment = add(point.second, point.rotation.lazyProduct(ConstCoordinates(q)),
                                point.rotation.lazyProduct(ConstCoordinates(v)));
    Eigen::Map<Coordinates>(force, 2 * kTwist) -= point.rotation.transpose().lazyProduct(moment);
  }
}

/// Adds Lambda of an element alone, to the bits of subtract_turned().
[[gnu::always_inline]] inline void add_turned(const TurnedMasses& masses, const double* q,
                                              Matrix3& sum) {
  const Position mean = mean_rotation(q);
  sum += turned_inertia(masses.sections, mean, mean);
  for (const PointInertia& point : masses.points) {
    const Position th =
        point.rotation.lazyProduct(Eigen::Map<const Eigen::Matrix<double, 2 * kTwist, 1>>(q));
    sum += turned_inertia(point.second, th, th);
  }
}

}  // namespace spoke::space
