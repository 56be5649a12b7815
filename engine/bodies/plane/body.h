#pragma once

// The table's data of a planar body: its terms, and the two-port to which it is condensed.

#include <array>

#include "engine/bodies/body_types.h"
#include "engine/bodies/coordinate_block.h"
#include "engine/bodies/plane/elastic_block.h"
#include "engine/bodies/plane/flex_layout.h"
#include "engine/bodies/plane/implicit_strain.h"
#include "engine/bodies/plane/section.h"
#include "models/plane/plane.h"

namespace spoke {
namespace plane {

/// Rotation of the frame of a body against its parent's.
struct JointMotion {
  Rotation R;  ///< R_PB
};

/// Terms of geometric stiffening in the hub's equation.
struct HubStiffening {
  double inertia = 0.0;  ///< qf^T KG qf, taken off the hub's rotary inertia [kg m^2]
  double rate = 0.0;     ///< qf^T KG qf' [kg m^2/s]
  double moment = 0.0;   ///< moment of the tension by applied forces and fields [N m]

  HubStiffening& operator+=(const HubStiffening& other) {
    inertia += other.inertia;
    rate += other.rate;
    moment += other.moment;
    return *this;
  }
};
/// Returns the moment on the hub by the stiffening, on the right-hand side: 2 w0 qf^T KG qf', and
/// that of the tension.
inline double calc_stiffening_moment(const HubStiffening& s, double w0) {
  return 2.0 * w0 * s.rate + s.moment;
}

/// Terms of a body's equations of motion that its state determines (docs/formulation.md, section
/// 2), all in the body frame. The flex vectors c_theta and Q_f belong to them.
struct Terms {
  Position S;             ///< first moment S0 + S qf [kg m]
  double rotary_inertia;  ///< M_ww [kg m^2]
  Twist Q;                ///< right-hand side of translation and rotation [N, N m]
  HubStiffening stiffening;
  double load_power;   ///< power of applied loads [W]
  double dissipation;  ///< qf'^T D qf' [W]
};

/// X_o. Of a straight beam xy, yx and rx are zero: axial and bending response decouple.
struct HandleMap {
  double xx = 1.0, xr = 0.0;
  double yy = 1.0, yr = 0.0;
  double ry = 0.0, rr = 1.0;
  double xy = 0.0, yx = 0.0, rx = 0.0;

  TwistMatrix matrix() const {
    TwistMatrix m;
    m << xx, xy, xr, yx, yy, yr, rx, ry, rr;
    return m;
  }
};

/// Relation of a body to its neighbours: from the forces on the two handles to their accelerations,
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

/// Wrenches on a body's two handles, in its frame: inboard, these are the multipliers of (P 8).
struct Wrenches {
  Twist inboard;
  Twist outboard;
};

/// Fields of a planar body in the table.
struct Fields {
  // Offsets of the handles' coordinates (u, v, psi) in flex vectors; for those that the reference
  // frame fixes, an offset into the padding, which is zero.
  std::array<int, kTwist> inboard_at{};
  std::array<int, kTwist> outboard_at{};
  double* c_theta = nullptr;         ///< M_fw = c0 + G^T qf (flex vector)
  double* Q_f = nullptr;             ///< right-hand side of the deformation (flex vector)
  ImplicitStrain* strain = nullptr;  ///< strains of second order in implicit steps; null: none
  /// Angular acceleration of the frame in the iterate before; set only with these [rad/s^2].
  double alpha = 0.0;
};

/// Memory of the formulation `structured` for a planar body.
struct Condensed {
  TwoPort port;
  double* W_theta = nullptr;   ///< response to an angular acceleration (flex vector)
  double* z = nullptr;         ///< response to Q_f (flex vector)
  Double2* scratch = nullptr;  ///< workspace of the solves
};

FlexLayout make_layout(const FlexibleBody& body);

/// Count the doubles that a body's own fields take, and its condensation.
std::size_t count_fields(const FlexibleBody& body);
std::size_t count_condensed(const FlexibleBody& body);
/// Places them in so much memory, which is zero and aligned to 16 bytes.
void place_fields(const FlexibleBody& body, double* memory, Fields& fields);
void place_condensed(const FlexibleBody& body, double* memory, Condensed& condensed);

/// Sets which places of flex vectors hold coordinates.
void set_extent(const FlexLayout& layout, CoordinateBlock& block);

/// Returns the sum of the squares of all coordinates up to which no deflection is above `range`
/// [m].
double calc_surely_linear(const FlexibleBody& body, double range);

}  // namespace plane

template <>
struct BodyTypes<Plane> {
  using Layout = plane::FlexLayout;
  using Block = plane::ElasticBlock;
  using Section = plane::Section;
  using Terms = plane::Terms;
  using Fields = plane::Fields;
  using Condensed = plane::Condensed;
  using HandleWrenches = plane::Wrenches;
  using JointMotion = plane::JointMotion;
  using HubStiffening = plane::HubStiffening;
  using ImplicitStrain = plane::ImplicitStrain;
  struct Attitude {};
  struct RecordedRotation {};
  struct CarriedInertia {};
};

}  // namespace spoke
