#pragma once

// Strains of second order on the left-hand side of an implicit step (docs/formulation.md, section
// 16): the tangent stiffness beta' h^2 K_t at the predicted shape, by the wrenches of the state at
// which the step begins, in place of the constant K; and the same tension on the rotation of the
// frame,
//   V = 1/2 sum over elements in tension N of int N (rotation of the frame + v')^2 dx.
// A step adds what it adds to the left, times the accelerations of the iterate before, to the
// right.

#include <array>
#include <vector>

#include "engine/bodies/plane/nonlinear_strain.h"

namespace spoke::plane {

struct ImplicitStrain {
  TangentFactors factors;  ///< of K, damping and beta' h^2 [s^2] in Mhat; that of Mff is 1
  NodalBand mass;          ///< Mff
  std::vector<Double2> S;  ///< first moments of the coordinates along x and y, by node [kg, kg m]

  std::vector<Twist> wrenches;  ///< K d by element, at the state at which the step begins

  NodalBand added;           ///< what Mhat has besides Mff
  std::vector<double> lean;  ///< coupling with the frame's rotation (flex vector) [kg m]
  double turn = 0.0;         ///< stiffness of the frame's rotation [kg m^2]
  NodalBand factor;          ///< factors of Mhat
  // Solutions, by node: of S; of unit forces on the outboard handle along x and y; of unit moments
  // on the outboard and on the inboard handle. Zero for what the frame fixes.
  std::array<std::vector<Double2>, 3> columns;
  SymmetricTwistMatrix S_W;  ///< S Mhat^-1 S^T; its last row is not used
};

/// Allocates it.
ImplicitStrain make_implicit_strain(const FlexibleBody& body, const TangentFactors& factors);

/// Keeps the wrenches at the flex vector q, before the step is predicted.
void keep_wrenches(const FlexibleBody& body, const double* q, ImplicitStrain& strain) noexcept;

/// Makes all else at the flex vector q.
void follow_strain(const FlexibleBody& body, const double* q, ImplicitStrain& strain) noexcept;

/// What is added to the equation of the frame's rotation.
struct FrameShare {
  double inertia = 0.0;  ///< on the left [kg m^2]
  double moment = 0.0;   ///< on the right [N m]
};
/// Adds to the left-hand side of a body, M_fw = c_theta, and to its right-hand side Q_f; `a`:
/// accelerations of the iterate, `alpha`: the angular one of the frame.
FrameShare add_implicit_strain(const ImplicitStrain& strain, const double* a, double alpha,
                               double* c_theta, double* Q_f) noexcept;

}  // namespace spoke::plane
