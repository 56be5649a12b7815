#pragma once

// Strains of second order on the left-hand side of an implicit step (docs/formulation.md, section
// 16): the tangent stiffness beta' h^2 K_t at the predicted shape, in place of the constant K,
//   K_t = sum of D^T K D + (second derivatives of d by the wrenches K d),
// with the wrenches of the state at which the step begins: those of a predicted shape may be far
// off where vibrations along the axis are not resolved. K_t need not be exact, since a step adds
// K_t (A - A_k) to the equations, A_k the accelerations of the iterate before. The same tension
// acts on the rotation of the frame, see implicit_tension.h.

#include <vector>

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/implicit_shift.h"

namespace spoke::space {

struct ImplicitStrain {
  BlockFactors factors;  ///< factors of D^T K D and of damping in Mhat; that of Mff is 1
  double gain = 0.0;     ///< beta' h^2 [s^2]

  std::vector<Twist> wrenches;  ///< K d by element, at the state at which the step begins
  std::vector<double> nodal;    ///< memory for that state by node, and by element

  BlockTridiagonal added;          ///< what Mhat* has besides Mff
  ImplicitShift shift;             ///< from Mhat* to Mhat
  std::vector<NodeMomentum> lean;  ///< by node: coupling with the frame's rotation
  Matrix3 turn = Matrix3::Zero();  ///< stiffness of the frame's rotation [kg m^2]
  ElasticBlock block;              ///< factors of Mhat
};

/// Allocates it; `gain`: beta' h^2 [s^2], `block`: the block of Mff alone.
ImplicitStrain make_implicit_strain(const FlexibleBody& body, const BlockFactors& factors,
                                    double gain, const ElasticBlock& block);

/// Keeps the wrenches at the flex vector q, before the step is predicted.
void keep_wrenches(const FlexibleBody& body, const double* q, ImplicitStrain& strain) noexcept;

/// Makes all else at the flex vector q.
void follow_strain(const FlexibleBody& body, const double* q, const BodyWork& work,
                   ImplicitStrain& strain) noexcept;

/// Adds K_t to the frame's mass terms and K_t A_k to the right-hand side, in the terms of a body
/// and the rows of `work`; `a`: the accelerations of the iterate A_k (flex vector), `turn`: the
/// angular one of the frame.
void add_implicit_strain(const FlexibleBody& body, const ImplicitStrain& strain, const double* a,
                         const Angular& turn, const BodyWork& work, BodyTerms& terms) noexcept;

}  // namespace spoke::space
