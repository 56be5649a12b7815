#pragma once

// How far a spatial body may deform: the range of linear elasticity, and limits beyond which its
// linear model means nothing.

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

/// Returns the largest deflection across the body's axis at its nodes and in the middle between
/// them, by its length. With strains of second order, which are linear in each element's own axes:
/// the largest deflection of an element, by the element's length.
double find_largest_deflection(const FlexibleBody& body, const double* q) noexcept;

/// A deformation coordinate that has left its limits.
struct LimitViolation {
  int node = -1;  ///< -1: none has
  int component = 0;
  double value = 0.0;
  double limit = 0.0;  ///< the body's length, or pi
};
/// Finds the first coordinate of a body that is not finite, or else the one farthest beyond its
/// limit.
LimitViolation find_limit_violation(const FlexibleBody& body, const double* q) noexcept;

}  // namespace spoke::space
