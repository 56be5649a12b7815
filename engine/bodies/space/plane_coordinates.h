#pragma once

// Coordinates and forces of an element along its own axes, both bending planes side by side: the
// part that tension stiffens.

#include "engine/bodies/space/body_data.h"
#include "models/support/simd.h"

namespace spoke::space {

/// Coordinates of an element's two nodes along its axes, as far as tension and torsion feel them.
/// Both planes lie side by side: (v, w) and (tz, -ty), the signs of the plane.
struct PlaneCoordinates {
  Double2 rise;      ///< rise of the outer node above the inner
  Double2 slope[2];  ///< slopes by node
  double torsion[2];
};

template <bool kIsStraight>
inline PlaneCoordinates in_element_axes(const BeamElement& element, const double* q) {
  PlaneCoordinates planes;
  const double* outer = q + kTwist;
  if constexpr (kIsStraight) {
    planes.rise = load(outer + 1) - load(q + 1);
    for (int node = 0; node < 2; ++node, q += kTwist) {
      planes.slope[node] = Double2{q[5], -q[4]};
      planes.torsion[node] = q[3];
    }
    return planes;
  }
  const Matrix3& e = element.axes;
  const auto along = [&](int axis, const double* x) {
    return e(0, axis) * x[0] + e(1, axis) * x[1] + e(2, axis) * x[2];
  };
  planes.rise = Double2{along(1, outer) - along(1, q), along(2, outer) - along(2, q)};
  for (int node = 0; node < 2; ++node, q += kTwist) {
    planes.slope[node] = Double2{along(2, q + kRotation), -along(1, q + kRotation)};
    planes.torsion[node] = along(0, q + kRotation);
  }
  return planes;
}

/// Subtracts forces along the element's axes from `force`.
template <bool kIsStraight>
inline void subtract_forces(const BeamElement& element, const PlaneCoordinates& f, double* force) {
  const Double2 shear = f.rise;
  const Matrix3& e = element.axes;
  for (int node = 0; node < 2; ++node, force += kTwist) {
    const double sign = node == 0 ? 1.0 : -1.0;
    const Double2 moment = f.slope[node];
    if constexpr (kIsStraight) {
      store(load(force + 1) + sign * shear, force + 1);
      force[3] -= f.torsion[node];
      store(load(force + 4) + Double2{moment[1], -moment[0]}, force + 4);
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      force[i] += sign * (e(i, 1) * shear[0] + e(i, 2) * shear[1]);
      force[3 + i] -= e(i, 0) * f.torsion[node] - e(i, 1) * moment[1] + e(i, 2) * moment[0];
    }
  }
}

/// Returns K x for one of an element's tension matrices, which do not feel motions that both nodes
/// share.
inline PlaneCoordinates multiply_planes(const Matrix4& K, const PlaneCoordinates& x) {
  const Double2 r = x.rise, a = x.slope[0], b = x.slope[1];
  return {K(2, 2) * r + K(1, 2) * a + K(3, 2) * b,
          {K(1, 2) * r + K(1, 1) * a + K(3, 1) * b, K(3, 2) * r + K(3, 1) * a + K(3, 3) * b},
          {}};
}

/// Returns, by plane, the sum of the products of forces and their coordinates.
inline Double2 sum_products(const PlaneCoordinates& f, const PlaneCoordinates& x) {
  return f.rise * x.rise + f.slope[0] * x.slope[0] + f.slope[1] * x.slope[1];
}

// The axes of a straight body's elements are those of the body.

inline PlaneCoordinates in_axes_of(const BeamElement& element, bool is_straight, const double* q) {
  return is_straight ? in_element_axes<true>(element, q) : in_element_axes<false>(element, q);
}
inline void subtract_forces_of(const BeamElement& element, bool is_straight,
                               const PlaneCoordinates& f, double* force) {
  is_straight ? subtract_forces<true>(element, f, force)
              : subtract_forces<false>(element, f, force);
}

}  // namespace spoke::space
