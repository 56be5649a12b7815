#pragma once

// The terms of a planar body, and what it is condensed to.

#include <array>

#include "engine/body/body_types.h"
#include "engine/body/coordinate_block.h"
#include "engine/body/elastic_block.h"
#include "engine/body/flex_layout.h"
#include "engine/body/section.h"
#include "models/system/plane.h"

namespace spoke {

/// Terms of a body's equations of motion that its state determines (docs/formulation.md, section
/// 2), all in the body frame. The flex vectors c_theta and Q_f belong to them.
struct PlanarTerms {
  Position S;                  ///< first moment S0 + S qf [kg m]
  double rotary_inertia;       ///< M_ww [kg m^2]
  Twist Q;                     ///< right-hand side of translation and rotation [N, N m]
  double centrifugal_inertia;  ///< qf^T KG qf [kg m^2]
  double centrifugal_rate;     ///< qf^T KG qf' [kg m^2/s]
  double load_power;           ///< of applied loads [W]
  double dissipation;          ///< qf'^T D qf' [W]
};

/// X_o of a straight beam, [xx 0 xr; 0 yy yr; 0 ry rr]: axial and bending response decouple.
struct HandleMap {
  double xx = 1.0, xr = 0.0;
  double yy = 1.0, yr = 0.0;
  double ry = 0.0, rr = 1.0;
};

/// What a body shows its neighbours: forces on the two handles to their accelerations,
/// a_i = P_ii F + P_io f + free_i, a_o = P_io^T F + P_oo f + free_o (all in the body frame).
struct TwoPort {
  SymmetricTwistMatrix
      S_inverse;  ///< inverse of the condensed rigid-body mass M_RR - C Mhat^-1 C^T
  Twist p;        ///< condensed rigid-body force [N, N m]
  // Handle accelerations per frame acceleration, deformation following: X_e = J_e - E_e W.
  HandleMap X_o;
  Twist x_i;  ///< last row of X_i; the others are the identity's, for the frame stands there
  SymmetricTwistMatrix P_ii, P_oo;
  TwistMatrix P_io;
  Twist free_i, free_o;  ///< accelerations of the handles without joint forces
};

template <>
struct BodyTypes<Plane> {
  using Layout = FlexLayout;
  using Block = ElasticBlock;
  using Section = spoke::Section;
  /// Offsets of the coordinates (u, v, psi) in flex vectors; of those that the reference frame
  /// fixes, one into the padding, which is zero.
  using Handle = std::array<int, kTwist>;
  using Terms = PlanarTerms;
  using Port = TwoPort;
  static constexpr int kCouplings = 1;
};

/// The moment about the hub by which geometric stiffening resists, at hub speed w0: 2 w0 qf^T KG
/// qf', `rate` [N m].
inline double calc_centrifugal_moment(double /*inertia*/, double rate, double w0) {
  return 2.0 * w0 * rate;
}

FlexLayout make_layout(const FlexibleBody& body);

/// Where a handle's coordinates stand in flex vectors.
std::array<int, kTwist> find_places(const FlexLayout& layout, const Handle& handle);

/// Sets which places of flex vectors hold coordinates.
void set_extent(const FlexLayout& layout, CoordinateBlock& block);

/// The sum of the squares of all coordinates up to which no deflection is above `range` [m].
double calc_surely_linear(const FlexibleBody& body, double range);

}  // namespace spoke
