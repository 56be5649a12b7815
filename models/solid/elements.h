#pragma once

// Shape functions, gradients and rules of quadrature of the elements, and the matrices of one
// element. Nodes stand in Abaqus's order.

#include <Eigen/Core>
#include <vector>

#include "models/solid_body.h"

namespace spoke::solid {

/// The most nodes that an element has.
inline constexpr int kMostNodes = 20;

/// A column per node of an element: places, gradients, displacements.
using NodeColumns = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMostNodes>;
/// A number per node of an element.
using NodeValues = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMostNodes, 1>;
/// A scalar matrix of an element.
using NodeMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostNodes, kMostNodes>;
/// The stiffness of an element: 3 x 3 for each two nodes, coordinates x, y, z of the first first.
using NodeStiffness = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                    3 * kMostNodes, 3 * kMostNodes>;

/// Shape functions at a place of the parent element, and the weight of it in a rule.
struct ShapePoint {
  double weight = 0.0;
  NodeValues N;    ///< by node
  NodeColumns dN;  ///< their derivatives by the coordinates of the parent element
};
/// A rule of quadrature on the parent element: a tetrahedron with corners at 0 and the three unit
/// vectors, or the cube from -1 to 1.
using ShapeRule = std::vector<ShapePoint>;

/// The rule of the stiffness: Abaqus's of 4 points for tet10, 27 for hex20, 8 for hex8; exact for
/// tet4.
const ShapeRule& stiffness_rule(spatial::ElementKind kind);
/// A rule that is exact for the mass, its density constant. Elements that are not curved have a
/// shorter one.
const ShapeRule& mass_rule(spatial::ElementKind kind, bool is_curved);
/// The rule of geometric stiffness, exact to degree 5.
const ShapeRule& stress_rule(spatial::ElementKind kind);

/// Returns the place of a node in the parent element.
Eigen::Vector3d parent_place(spatial::ElementKind kind, int node);
/// Returns shape functions and their derivatives at a place of the parent element; weight 0.
ShapePoint calc_shapes(spatial::ElementKind kind, const Eigen::Vector3d& place);

/// Returns the places of an element's nodes.
NodeColumns places_of(const spatial::SolidMesh& mesh, const spatial::SolidElement& element);
/// Tells whether a mid node of a tetrahedron is not in the middle, or a hexahedron is no
/// parallelepiped with its mid nodes in the middles.
bool is_curved(spatial::ElementKind kind, const NodeColumns& x);

/// Writes the gradients of the shape functions and returns det J, the volume by that of the parent
/// element; is it not positive, the gradients mean nothing.
double calc_gradients(const ShapePoint& point, const NodeColumns& x, NodeColumns& gradients);

/// Returns the least det J at the points of the rules: is it not positive, the element is inverted
/// or degenerate.
double least_volume_ratio(spatial::ElementKind kind, const NodeColumns& x);

/// The least det J at the nodes of an element. Below zero, the element is folded over there, even
/// if no point of the rules is.
struct NodeVolume {
  int node = 0;
  double ratio = 0.0;
};
NodeVolume least_volume_at_nodes(spatial::ElementKind kind, const NodeColumns& x);

/// Returns the scalar mass matrix: sum W rho N_i N_j.
NodeMatrix calc_mass(spatial::ElementKind kind, const NodeColumns& x, double density);

/// Lame's constants of an isotropic material.
struct Lame {
  double lambda = 0.0;  ///< [Pa]
  double mu = 0.0;      ///< [Pa]
};
Lame lame_of(const spatial::SolidMaterial& material);

/// Returns the stiffness matrix.
NodeStiffness calc_stiffness(spatial::ElementKind kind, const NodeColumns& x, const Lame& material);

/// Returns the linear stress of displacements u with gradients of the shape functions at a point.
Eigen::Matrix3d calc_stress(const NodeColumns& gradients, const NodeColumns& u,
                            const Lame& material);

}  // namespace spoke::solid
