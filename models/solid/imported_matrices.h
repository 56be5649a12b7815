#pragma once

// Matrices of a solid that other programs have assembled, as they are read.

#include <Eigen/SparseCore>
#include <array>
#include <memory>
#include <vector>

#include "models/solid_body.h"
#include "models/space/solid.h"

namespace spoke::solid {

/// Matrices of a solid of n nodes, three coordinates a node, in SI units.
struct ImportedMatrices {
  using Sparse = Eigen::SparseMatrix<double>;

  std::vector<space::Position> nodes;  ///< places [m]
  std::vector<int> labels;             ///< numbers of the nodes in their file
  /// The same nodes with the sets of their file, by which interfaces are chosen; no elements.
  std::shared_ptr<const spatial::SolidMesh> mesh;
  /// n x n, both triangles, M = m (x) 1_3; positive definite. It has entries, 0 if need be,
  /// wherever those of stresses have some [kg].
  Sparse m;
  Sparse K;  ///< 3 n x 3 n, both triangles; rows 3 node + axis [N/m]
  /// Scalars kg with K_G = kg (x) 1_3 of the stresses under loads - M A^(k) x [kg] and - M e_c
  /// [kg/m]; n x n, both triangles. Of size 0 if there are none.
  std::array<Sparse, space::kSpins> own;
  std::array<Sparse, 3> translation;

  bool has_stresses() const { return own[0].size() > 0; }
};

}  // namespace spoke::solid
