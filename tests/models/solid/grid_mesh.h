#pragma once

// Meshes of boxes for tests.

#include <array>
#include <functional>

#include "models/solid_body.h"

namespace spoke::test {

/// A box [0, L] of nx * ny * nz cells: one hexahedron each, or six Kuhn tetrahedra.
struct GridMesh {
  std::array<int, 3> cells{1, 1, 1};
  std::array<double, 3> lengths{1.0, 1.0, 1.0};  ///< [m]
  spatial::ElementKind kind = spatial::ElementKind::tet10;
  std::array<double, 3> shift{};  ///< added to all places [m]
  /// Whether cell (i, j, k) is kept; empty: all are.
  std::function<bool(int, int, int)> keeps{};
};

/// Returns the mesh: its nodes are those of the grid of half cells that elements use, in the order
/// of i + (2 nx + 1) (j + (2 ny + 1) k). It has the sets X0, X1, Y0, Y1, Z0, Z1, the nodes at the
/// least and the greatest x, y and z of the grid with their faces.
spatial::SolidMesh make_grid_mesh(const GridMesh& grid);

}  // namespace spoke::test
