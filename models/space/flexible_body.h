#pragma once

// A flexible body in space in its floating frame B, as the constants that its equations of motion
// need (docs/formulation.md, section 10). Node k = 0..E has the coordinates (u, v, w, tx, ty, tz),
// displacement and small rotation, in B. A flex vector holds them node after node, without those
// that the reference frame fixes.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "models/rotor.h"
#include "models/space/beam_element.h"
#include "models/space/block_tridiagonal.h"
#include "models/space/directions.h"
#include "models/space/element_second_order.h"

namespace spoke::space {

/// Whether coordinates i and j of nodes belong to one direction of a decoupled body.
constexpr bool is_one_direction(int i, int j) {
  constexpr int kPartner[] = {0, 5, 4, 3, 2, 1};
  return i == j || i == kPartner[j];
}

struct FlexibleBody {
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  int elements = 0;
  Pose pose;  ///< pose of B, undeformed, in the frame of the beam
  /// Undeformed places of the nodes in B, the first at its origin [m].
  std::vector<Position> nodes;
  std::vector<double> stations;  ///< stations of the nodes on the beam [m]
  std::vector<BeamElement> beam;
  std::vector<ElementSecondOrder> second_order;  ///< by element; empty: strains are linear
  bool is_straight = false;  ///< whether the axes of all elements are those of B
  /// Whether its directions are decoupled: u, tx, (v, tz) and (w, ty) in K and D, and places and x
  /// axes, y axes, z axes in the slots. Then the body is straight, and its sections are symmetric
  /// about y and z.
  bool is_decoupled = false;
  /// Its directions, if it is decoupled and no small masses turn with it.
  std::optional<Directions> directions;
  bool is_damped = false;  ///< whether D is not zero
  /// Nodes at which joints and loops hold the body: first node 0 (the inboard handle), then one for
  /// each child in the children's order, then one for each place of a loop; these may repeat.
  std::vector<int> handles;

  double mass = 0.0;               ///< [kg]
  Position S0 = Position::Zero();  ///< undeformed first moment [kg m]
  Matrix3 J0 = Matrix3::Zero();    ///< undeformed int r r^T dm [kg m^2]
  SlotMasses slots;
  std::vector<NodeMomentum> C_t;  ///< C_t by node [kg, kg m]
  // Matrices over all coordinates of all nodes, those that the frame fixes included.
  BlockTridiagonal M;  ///< Mff [kg, kg m, kg m^2]
  BlockTridiagonal K;  ///< elastic stiffness [N/m, N, N m]
  BlockTridiagonal D;  ///< damping of the sections [N s/m, N s, N m s]

  /// Whether strains are of second order; then it has neither directions nor a TensionPlace.
  bool is_nonlinear() const { return !second_order.empty(); }
  /// Returns the length from the first to the last node [m].
  double length() const { return nodes.back().x(); }
  int node_count() const { return elements + 1; }
  /// Returns the first node that has coordinates.
  int first_node() const { return reference_frame == ReferenceFrame::clamped ? 1 : 0; }
  /// Returns nf, the number of deformation coordinates.
  int coordinates() const { return kTwist * elements; }
  /// Returns the index of a coordinate of a node in flex vectors; -1 if the reference frame fixes
  /// it. `clamped` fixes node 0; `chord` u, v, w, tx of node 0, and v, w of node E.
  int coordinate(int node, int component) const;
};

/// Assembles the constants of a body, element by element. Throws nothing; preconditions: compliance
/// and mass are positive definite, except that compliance may be zero in shear; handles are as in
/// FlexibleBody.
FlexibleBody make_beam_body(const Beam& beam, std::vector<double> stations,
                            ReferenceFrame reference_frame, std::vector<int> handles);

/// Returns the stations of a body's nodes with elements of equal length.
std::vector<double> equal_stations(double from, double to, int elements);

}  // namespace spoke::space
