#pragma once

// Elastic and damping forces of a planar body whose strains are of second order
// (docs/formulation.md, section 16): U = sum over elements of 1/2 d^T K d, with d of
// element_strain.h and, along the element, what a tension that varies from element to element adds:
//   d_x += psi_k - psi_(k+1),   psi_k = (h of the elements inboard and outboard of node k)/2,
//   h = int y v'^2/2 dx,  y from -1/2 to 1/2 along the element,
// h of the first and of the last element whole; psi is zero at the ends of the body.

#include "engine/bodies/plane/element_strain.h"
#include "engine/bodies/plane/flex_layout.h"
#include "engine/bodies/plane/nodal_band.h"
#include "models/plane/flexible_body.h"

namespace spoke::plane {

/// Subtracts the elastic force at q and the damping force at v, D^T (K_D + stiffness_factor K) d',
/// from Q (flex vectors). Returns the power that damping takes at v [W].
double subtract_strain_forces(const FlexibleBody& body, const FlexLayout& layout,
                              double stiffness_factor, const double* q, const double* v,
                              double* Q) noexcept;

/// Returns U [J] at a flex vector.
double calc_nonlinear_energy(const FlexibleBody& body, const FlexLayout& layout,
                             const double* q) noexcept;

/// Returns the strain d of an element at a flex vector, psi included.
Twist calc_strain(const FlexibleBody& body, const FlexLayout& layout, int e,
                  const double* q) noexcept;

/// Returns its rate at rates v (flex vectors).
Twist calc_strain_rate(const FlexibleBody& body, const FlexLayout& layout, int e, const double* q,
                       const double* v) noexcept;

/// Returns K d of an element, of which the first component is its tension [N, N, N m].
Twist calc_strain_wrench(const FlexibleBody& body, const FlexLayout& layout, int e,
                         const double* q) noexcept;

/// Factors of K and of the damping K_D, and of the second derivatives of d by the wrenches K d.
struct TangentFactors {
  double stiffness = 0.0, damping = 0.0, geometric = 0.0;
};
/// Adds to a matrix the sum over elements of D^T (factors.stiffness K + factors.damping K_D) D +
/// factors.geometric (second derivatives of d by the wrenches, one an element), at a flex vector.
void add_tangents(const FlexibleBody& body, const FlexLayout& layout, const TangentFactors& factors,
                  const double* q, const Twist* wrenches, NodalBand& sum) noexcept;

/// Returns the stiffness d(elastic force)/dq, and the damping D^T (K_D + stiffness_factor K) D, at
/// a flex vector, over the coordinates.
Eigen::MatrixXd calc_strain_stiffness(const FlexibleBody& body, const FlexLayout& layout,
                                      const double* q);
Eigen::MatrixXd calc_strain_damping(const FlexibleBody& body, const FlexLayout& layout,
                                    double stiffness_factor, const double* q);

}  // namespace spoke::plane
