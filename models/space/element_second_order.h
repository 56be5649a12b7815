#pragma once

// What an element's strains have of second order in the displacements of its ends, as constants
// (docs/formulation.md, section 16).
//
// The flexibility of an element takes a wrench on the outer node, F, to strains along it: C^-1 W F.
// These, to first order, make the outer node move by d = (d_t; d_r) as seen from the inner one, and
// turn the section at s by del(s) = int k. To second order the outer node is at
//   Q_1^T (l + De) = l + d_t + c(d),    log(Q_1^T Q_2) = d_r + a(d)
// with k(s), g(s) the curvature and the strain of the reference line per d, in B, t the tangent,
//   a = 1/2 int del x k ds,   c = int [al x t + 1/2 del x (del x t) + del x g] ds,
//   al(s) = 1/2 int del x k
// so that the strains which the element feels are those of its ends less c and a.

#include <array>
#include <vector>

#include "models/space/beam_element.h"

namespace spoke::space {

struct ElementSecondOrder {
  /// Symmetric matrices of three quadratic forms: component i is 1/2 d^T form[i] d, in B.
  using Forms = std::array<TwistMatrix, 3>;
  Forms place;     ///< of c [m, m/rad, m/rad^2], less what a twist draws out by Wagner's effect
  Forms rotation;  ///< of a [rad/m^2, 1/m, 1/rad]

  /// int P dx of the sections' second moments about their centres of mass, in B [kg m^2]: what
  /// turns with the mean rotation of the nodes, and is taken off the body's inertia.
  Matrix3 turning = Matrix3::Zero();
  /// Small masses, whose sections turn as a whole; about their centres.
  std::vector<PointInertia> inertias;
};

/// Makes them for the elements of a body.
std::vector<ElementSecondOrder> make_second_order(const Beam& beam, const BodyGeometry& geometry,
                                                  const std::vector<BeamElement>& elements);

}  // namespace spoke::space
