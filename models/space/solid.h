#pragma once

// A solid in space in its floating frame B, as the constants that its equations of motion need
// (docs/formulation.md, section 13): a slot body whose slots are the nodes of a mesh, with the
// scalar mass matrix m (n x n, M = m (x) 1_3), places x_i and displacements u = Xi q.
// models/solid/ makes them.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "models/solid_body.h"
#include "models/space/rotation.h"
#include "models/space/vectors.h"

namespace spoke::space {

/// A place on a solid: an interface, a set of nodes that a load is spread over, or a node. At rest
/// it is at p; deformed at p + E_u q, turned by exp((E_th q)~); a wrench on it acts by E^T.
struct SolidPlace {
  std::string name;
  Position p = Position::Zero();  ///< at rest, in B [m]
  double area = 0.0;              ///< of its faces [m^2]; 0: it has none
  /// The columns of E = [E_u; E_th] that are not zero, and the coordinates that they belong to.
  /// Empty: the frame fixes the place.
  std::vector<int> at;
  std::vector<Twist> columns;

  bool is_fixed() const { return at.empty(); }
};

/// The monomials of w of which A(w) = w w^T - |w|^2 1 is a sum: wx^2, wy^2, wz^2, wy wz, wx wz,
/// wx wy.
inline constexpr int kSpins = 6;
/// Returns A^(k): e_a e_a^T - 1 of the squares, e_a e_b^T + e_b e_a^T of the products.
Matrix3 spin_matrix(int k);
/// Returns the values of the monomials.
std::array<double, kSpins> spin_monomials(const Angular& w);

/// Matrices of a solid in r modes, Mff = 1: u = Phi q, Phi_a (n x r) the rows of axis a.
struct ReducedSolid {
  Eigen::VectorXd stiffness;  ///< W^2 of each mode [1/s^2]
  Eigen::VectorXd damping;    ///< 2 zeta W of each mode [1/s]
  Eigen::MatrixXd C_t;        ///< r x 3: column a is Phi_a^T m 1
  /// p_ab = h_ba^T + m_ab q with h_ab = x_a^T m Phi_b and m_ab = Phi_a^T m Phi_b: number 3 a + b.
  std::array<Eigen::VectorXd, 9> h;  ///< h[3 a + b] = h_ba^T = Phi_a^T m x_b
  std::array<Eigen::MatrixXd, 9> m;  ///< m[3 a + b] = m_ab, r x r
  // Geometric stiffness of the stresses under unit loads, r x r each; empty without stiffening.
  std::array<Eigen::MatrixXd, kSpins> own;             ///< K_G of the loads - M A^(k) x
  std::array<Eigen::MatrixXd, 3> translation;          ///< K_G of the loads - M e_c
  std::vector<std::array<Eigen::MatrixXd, 6>> places;  ///< by place: of unit wrenches on it
  Eigen::MatrixXd shapes;                              ///< Phi by node (3 n x r), for output
};

/// Matrices of a solid in the coordinates of its nodes.
struct NodalSolid {
  using Sparse = Eigen::SparseMatrix<double>;

  Sparse m;             ///< n x n, symmetric, both triangles [kg]
  Sparse K;             ///< nf x nf, symmetric, both triangles
  Sparse Xi;            ///< 3 n x nf: u = Xi q
  Eigen::MatrixXd C_t;  ///< nf x 3: Xi^T (m 1 (x) 1_3); set by set_derived()
  // Geometric stiffness as of ReducedSolid: the scalars kg with K_G = Xi^T (kg (x) 1_3) Xi, as
  // values in the places of those of m; empty without stiffening.
  std::array<Eigen::VectorXd, kSpins> own;
  std::array<Eigen::VectorXd, 3> translation;
  std::vector<std::array<Eigen::VectorXd, 6>> places;
  /// First coordinate of each slice, then the first of those that couple slices: K and Mff link
  /// none of a slice with one of another (models/solid/order_coordinates.h). Empty: one slice.
  std::vector<int> slices;
};

/// Constants of a solid that do not depend on the tree that it stands in.
struct SolidConstants {
  double mass = 0.0;               ///< [kg]
  Position S0 = Position::Zero();  ///< undeformed first moment about B's origin [kg m]
  Matrix3 J0 = Matrix3::Zero();    ///< undeformed int r r^T dm [kg m^2]
  int coordinates = 0;             ///< r or nf
  double extent = 0.0;             ///< greatest distance of a node from B's origin [m]
  spatial::SolidFrame frame = spatial::SolidFrame::clamped;
  bool is_stiffened = false;
  /// Interfaces in the order of the description, then the sets that loads act on.
  std::vector<SolidPlace> places;
  int interfaces = 0;  ///< count of interfaces
  /// The place that is shown as the body's tip: the last interface if there are outboard ones, else
  /// the node farthest from B's origin; set by set_derived().
  SolidPlace tip;
  int tip_number = -1;  ///< its number among the places; -1: it is a node
  /// Values of the coordinates at which a node is moved by `extent`, beyond which a linear model
  /// means nothing; set by set_derived().
  std::vector<double> limits;
  double least_limit = 0.0;  ///< the least of them
  /// Strains of chosen nodes, stress by Young's modulus, in the order of `stress`, six rows a node,
  /// by coordinate: for the range of linear elasticity. Empty: not known, or coordinates are nodal;
  /// set by set_derived().
  Eigen::MatrixXd strain_modes;
  double youngs_modulus = 0.0;  ///< [Pa]; 0: not known
  std::variant<ReducedSolid, NodalSolid> matrices;
  // For output.
  std::shared_ptr<const spatial::SolidMesh> mesh;  ///< null: matrices were imported
  std::vector<Position> nodes;                     ///< places of the nodes in B at rest [m]
  /// Stress of nodes, the mean over their elements: (xx, yy, zz, yz, xz, xy) by node, 6 n x 3 n,
  /// from displacements by node [Pa/m]. Empty: the material is not known.
  Eigen::SparseMatrix<double, Eigen::RowMajor> stress;
  std::vector<double> frequencies;  ///< of the vibration modes before they were combined [Hz]

  /// Returns C_t^T, a row of three by coordinate [kg, or sqrt(kg) of a reduced solid].
  const Eigen::MatrixXd& C_t() const { return reduced() ? reduced()->C_t : nodal()->C_t; }
  const ReducedSolid* reduced() const { return std::get_if<ReducedSolid>(&matrices); }
  const NodalSolid* nodal() const { return std::get_if<NodalSolid>(&matrices); }
};

/// Makes the place of a node, which has no rotation.
SolidPlace make_node_place(const SolidConstants& constants, int node);
/// Sets what follows from all else: tip, limits, strains, and C_t of a nodal solid. Precondition:
/// the members but these are set and there are coordinates.
void set_derived(SolidConstants& constants);
/// Returns the trace of K [N/m, N m, or 1/s^2 of a reduced solid].
double calc_stiffness_trace(const SolidConstants& constants);
/// Returns the displacements of all nodes, x, y, z by node, at a flex vector [m].
Eigen::VectorXd calc_displacements(const SolidConstants& constants, const double* q);
/// Returns the name of a coordinate: "mode 7", "coordinate 7".
std::string name_coordinate(const SolidConstants& constants, int coordinate);

/// A solid in its tree: its constants, and which of its places are handles.
struct Solid {
  std::shared_ptr<const SolidConstants> constants;
  /// Places at which joints and loops hold it: first place 0 (the inboard handle), then one for
  /// each child in the children's order, then one for each place of a loop; these may repeat.
  std::vector<int> handles;

  int coordinates() const { return constants->coordinates; }
  const SolidPlace& handle(std::size_t h) const {
    return constants->places[static_cast<std::size_t>(handles[h])];
  }
};

}  // namespace spoke::space
