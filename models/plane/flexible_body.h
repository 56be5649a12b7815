#pragma once

// A flexible body in its floating frame, as the constants that its equations of motion need
// (docs/formulation.md, section 2). Deformation: axial displacements u_k and bending coordinates
// v_k, psi_k (deflection, rotation) of the nodes, less those that the reference frame fixes.

#include <Eigen/Core>
#include <array>
#include <compare>
#include <memory>
#include <vector>

#include "models/plane/beam_pieces.h"
#include "models/plane/symmetric_band.h"
#include "models/rotor.h"

namespace spoke::plane {

/// An attachment node of a body: where joints hold it.
struct Handle {
  int node = 0;
  Position p = Position::Zero();  ///< undeformed place in the body frame [m]
  /// Index of the node's coordinates (u, v, psi) in the order "axial, then bending"; -1 where the
  /// reference frame fixes the coordinate to zero.
  std::array<int, kTwist> coordinate{-1, -1, -1};
};

/// The inertia coupling H = int rhoA N_u^T N_v (E x 2E). Each axial row touches six neighbouring
/// bending coordinates, each pair of bending coordinates (2 k, 2 k + 1) at most four neighbouring
/// axial ones; both are stored by rows for products from either side. Entries outside the matrix
/// are zero.
struct AxialBendingCoupling {
  static constexpr int kWidth = 6;
  static constexpr int kHeight = 4;

  int offset = 0;  ///< row i begins at bending coordinate 2 i + offset
  Eigen::VectorXd
      rows;  ///< kWidth each, row by row, as many as axial vectors have values [kg, kg m]
  /// By pair k: for axial coordinates k - 2 to k + 1 the two entries, side by side: E x kHeight
  /// x 2.
  Eigen::VectorXd pairs;

  double& at(int i, int column) { return rows[i * kWidth + column - (2 * i + offset)]; }
  /// Fills `pairs` from `rows`.
  void transpose();
};

/// Damping of a body in proportion to its stiffness, besides that of the whole system.
struct StrainDamping {
  double axial = 0.0;    ///< factor of K_axial [s]
  double bending = 0.0;  ///< factor of K_bending [s]

  bool is_zero() const { return axial == 0.0 && bending == 0.0; }
  auto operator<=>(const StrainDamping&) const = default;
};

/// Constant integrals over one body, in its frame (x along the undeformed axis). Bodies of one kind
/// share one object.
struct FlexibleBody {
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  int elements = 0;
  double length = 0.0;  ///< [m]

  double mass = 0.0;               ///< m [kg]
  Position S0 = Position::Zero();  ///< int rhoA s0 dx, the undeformed first moment [kg m]
  // Axial vectors have E values and, if E is odd, one more zero, since they are taken two at a
  // time.
  Eigen::VectorXd S_axial;    ///< row x of S = int rhoA N dx [kg]
  Eigen::VectorXd S_bending;  ///< row y of S: 2E values [kg, kg m]
  double I0 = 0.0;            ///< int rhoA s0 . s0 dx [kg m^2]
  Eigen::VectorXd d_axial;    ///< d0 = int rhoA N^T s0 dx, axial part [kg m]
  Eigen::VectorXd c_bending;  ///< c0 = int rhoA N^T B s0 dx, bending part [kg m, kg m^2]

  SymmetricBand<1> M_axial;    ///< axial block of Mff [kg]
  SymmetricBand<3> M_bending;  ///< bending block of Mff [kg, kg m, kg m^2]
  SymmetricBand<1> K_axial;    ///< elastic stiffness, axial [N/m]
  SymmetricBand<3> K_bending;  ///< elastic stiffness, bending [N/m, N, N m]
  /// By element, if strains are of second order: the stiffness against displacement and rotation of
  /// its outer node while the inner one stands. K_axial and K_bending are then zero.
  std::vector<TwistMatrix> strain_stiffness;
  /// And what turned small masses take off the rotary inertia, sum of J N_v'^T N_v' [kg m^2, ...];
  /// of size 0 without such masses: their place is linear in the rotation of their section.
  SymmetricBand<3> turning;
  AxialBendingCoupling H;
  StrainDamping damping;

  Handle inboard;
  Handle outboard;
  /// The pieces of a body that is not uniform.
  std::vector<BeamPiece> pieces;
  std::vector<BodyMass> masses;

  bool is_nonlinear() const { return !strain_stiffness.empty(); }
  int axial() const { return elements; }
  /// Returns the length of the axial vectors: E, made even.
  int padded_axial() const { return elements + elements % 2; }
  int bending() const { return 2 * elements; }
  /// Returns nf, the number of deformation coordinates.
  int coordinates() const { return kTwist * elements; }

  /// Returns the index of coordinate `component` (u, v, psi) of node 0..E in the order "axial, then
  /// bending"; -1 if the reference frame fixes it.
  int coordinate(int node, int component) const;
};

/// Geometric stiffening of a planar body; empty unless the blade has it.
struct Stiffening {
  std::shared_ptr<const SymmetricBand<3>> centrifugal;  ///< KG of make_centrifugal_stiffness
  /// make_slope_integral, for the tip's displacement.
  std::shared_ptr<const SymmetricBand<3>> slope_integral;
  /// make_outboard_mass_stiffness(), for a field that acts on all masses alike; none without a
  /// field.
  std::shared_ptr<const SymmetricBand<3>> outboard_mass;

  explicit operator bool() const { return centrifugal != nullptr; }
};

}  // namespace spoke::plane
