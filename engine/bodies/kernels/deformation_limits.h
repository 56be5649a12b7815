#pragma once

// How far a body may deform: the range of linear elasticity, beyond which results are doubtful, and
// limits beyond which its linear model means nothing.

#include "engine/bodies/table/body_kind.h"

namespace spoke {

/// Returns the largest deflection of a body at its nodes and in the middle between them, by its
/// length; 0 if it is within the linear range.
double find_large_deflection(const BodyData<Plane>& body) noexcept;

/// The same measure for a spatial body; 0 for a rigid one.
inline double find_large_deflection(const BodyData<Space>& body) noexcept {
  return body.kind->find_large_deflection(body);
}

/// Whether a coordinate is not finite or beyond its limit.
bool has_left_limits(const BodyData<Plane>& body) noexcept;
inline bool has_left_limits(const BodyData<Space>& body) noexcept {
  return body.kind->has_left_limits(body);
}

/// A deformation coordinate that has left its limits.
struct LimitViolation {
  int coordinate = -1;  ///< in the order "axial, then bending"; -1: none has
  double value = 0.0;
  double limit = 0.0;
};
/// Finds the first coordinate of a body that is not finite, or else the one farthest beyond its
/// limit.
LimitViolation find_limit_violation(const BodyData<Plane>& body);

}  // namespace spoke
