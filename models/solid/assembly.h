#pragma once

// Matrices of a mesh in the displacements of its nodes, three each: mass, stiffness, geometric
// stiffness and stress. Sums are taken element by element in the mesh's order.

#include <Eigen/SparseCore>
#include <vector>

#include "models/solid_body.h"

namespace spoke::solid {

using Sparse = Eigen::SparseMatrix<double>;

/// Mass and stiffness of a body that nothing holds, both triangles.
struct NodeMatrices {
  Sparse m;  ///< n x n: the mass matrix is m (x) 1_3 [kg]
  Sparse K;  ///< 3 n x 3 n, x, y, z of a node side by side [N/m]
};

/// Assembles mass and stiffness. Precondition: no element is inverted.
NodeMatrices assemble(const spatial::SolidMesh& mesh, const spatial::SolidMaterial& material);

/// Returns the geometric stiffness of the linear stress of displacements (a column of 3 n each), as
/// values in the places of those of m, a column each: K_G = kg (x) 1_3.
Eigen::MatrixXd calc_geometric_stiffness(const spatial::SolidMesh& mesh,
                                         const spatial::SolidMaterial& material, const Sparse& m,
                                         const Eigen::MatrixXd& displacements);

/// Returns the matrix that makes stresses of nodes (xx, yy, zz, yz, xz, xy by node) from
/// displacements: those of the points of integration, extrapolated to the nodes of each element,
/// and of the elements of a node the mean [Pa/m].
Eigen::SparseMatrix<double, Eigen::RowMajor> make_stress_operator(
    const spatial::SolidMesh& mesh, const spatial::SolidMaterial& material);

/// Returns X^T A X of a symmetric A, symmetric in its bits.
Sparse project(const Sparse& A, const Sparse& X);

}  // namespace spoke::solid
