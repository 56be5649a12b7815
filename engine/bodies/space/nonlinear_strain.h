#pragma once

// Elastic and damping forces of a body whose strains are of second order (docs/formulation.md,
// section 16): U = sum over elements of 1/2 d^T K d, with d of element_strain.h and, along the
// element, what a tension that varies from element to element adds:
//   d_x += psi_k - psi_(k+1),   psi_k = (h of the elements inboard and outboard of node k),
//   h = int y (v'^2 + w'^2)/2 dx,  y from -1/2 to 1/2 along the element,
// which is how far a node moves along the axis where the slopes within its elements do; psi is zero
// at the ends of the body. The mean of a tension N over an element comes from d alone, its change
// along the element from this: tension by distributed forces is then exact to first order in each.

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/element_strain.h"
#include "engine/bodies/space/turned_sections.h"

namespace spoke::space {

/// Flex vectors by node.
struct NodalMotion {
  const double* q = nullptr;
  const double* v = nullptr;
};

/// Subtracts the elastic force at `elastic`.q and the damping force at `elastic`.v, D^T (K_D +
/// stiffness_factor K) d', from the forces by node. Returns the power that damping takes at
/// `motion` [W]. `scratch`: three doubles an element.
double subtract_strain_forces(const FlexibleBody& body, double stiffness_factor,
                              const NodalMotion& elastic, const NodalMotion& motion,
                              double* scratch, double* force) noexcept;

/// Returns U [J] at coordinates by node. `scratch`: three doubles an element.
double calc_nonlinear_energy(const FlexibleBody& body, const double* q, double* scratch) noexcept;

/// Returns the strain d of element e at a flex vector, psi included: of second order what
/// calc_relative() is to first order.
Twist calc_strain(const FlexibleBody& body, int e, const double* q) noexcept;
/// Returns its rate at rates v; q, v: flex vectors.
Twist calc_strain_rate(const FlexibleBody& body, int e, const double* q, const double* v) noexcept;

/// Sets the wrenches K d of the elements, of which the component along the element's axis is their
/// tension, at coordinates by node; `scratch`: three doubles an element.
void calc_strain_wrenches(const FlexibleBody& body, const double* q, double* scratch,
                          Twist* wrenches) noexcept;

/// Adds to a matrix over all nodes the sum over elements of D^T (factors.stiffness K +
/// factors.damping K_D) D + gain (second derivatives of d and psi by the wrenches), D without psi:
/// see implicit_shift.h.
void add_tangents(const FlexibleBody& body, const BlockFactors& factors, double gain,
                  const double* q, const Twist* wrenches, BlockTridiagonal& sum) noexcept;

/// Sets the shift at coordinates by node.
void set_shift(const FlexibleBody& body, const double* q, ImplicitShift& shift) noexcept;

/// Returns what turned sections take off the inertia of a body at an angular velocity w of B, and
/// subtracts its forces.
TurnedInertia subtract_turning(const FlexibleBody& body, const Angular& w,
                               const NodalMotion& motion, double* force) noexcept;
/// Returns it, of value alone.
Matrix3 calc_turned_inertia(const FlexibleBody& body, const double* q) noexcept;

/// Returns the stiffness d(elastic force)/dq at coordinates by node, and the damping D^T (K_D +
/// stiffness_factor K) D, over the flex vector.
struct StrainMatrices {
  Eigen::MatrixXd stiffness, damping;
};
StrainMatrices calc_strain_matrices(const FlexibleBody& body, double stiffness_factor,
                                    const double* q);

}  // namespace spoke::space
