#pragma once

// The constants of a solid's nodal coordinates as the kernels of its terms read them, by slices:
// each tile has all that one slice's rows need, in the order in which it is read.

#include <vector>

#include "models/space/solid.h"

namespace spoke::space {

/// A column of Xi at a node: u = sum q column.
struct NodeColumn {
  int coordinate = 0;
  double column[3] = {};
};

/// Neighbouring rows of K with the same columns, four at most: by column, the values of four rows.
struct StiffnessRows {
  int first = 0;  ///< coordinate of the first row
  int count = 0;
  std::size_t begin = 0, end = 0;  ///< columns, in NodalTile::K_columns
};

/// The rows of one slice. Its nodes are those that it moves, those of coordinates behind its end,
/// and fixed ones there; their neighbours follow.
struct NodalTile {
  int first = 0, end = 0;  ///< coordinates of the slice
  // Coordinates between slices that it adds to, and where its share in them stands: counted behind
  // all coordinates.
  int first_between = 0, end_between = 0;
  int share = 0;

  int first_motion = 0;           ///< place of its motions in NodalWork::motions
  int own = 0;                    ///< nodes whose terms it has; they come first
  std::vector<int> nodes;         ///< number of each node in the mesh
  std::vector<double> places;     ///< by node four: the place at rest [m], and 0
  std::vector<int> first_column;  ///< by node, and the end: in `columns`
  std::vector<NodeColumn> columns;

  std::vector<int> first_mass;  ///< by own node, and the end: in `mass_nodes`
  std::vector<int> mass_nodes;  ///< numbers of nodes of the tile
  std::vector<double> m;        ///< values of m there
  std::vector<double> forms;    ///< values of the stiffening's kg there: all matrices of one entry

  std::vector<StiffnessRows> K_rows;
  std::vector<int> K_columns;  ///< coordinates
  std::vector<double> K;       ///< by column four
  std::vector<double> Mff;     ///< as K
};

/// All tiles of a solid.
struct NodalTiles {
  std::vector<NodalTile> tiles;
  int coordinates = 0;
  int between = 0;  ///< first coordinate between slices
  int shares = 0;   ///< rows of all tiles' shares
  int forms = 0;    ///< geometric stiffness matrices, a multiple of three
  int nodes = 0;    ///< nodes of all tiles

  int count() const { return static_cast<int>(tiles.size()); }
  /// Returns the rows that the terms take: the coordinates, and the shares.
  int rows() const { return coordinates + shares; }
  /// Returns the values of a tile in NodalWork::forms. Those of two tiles lie in different lines of
  /// a cache.
  int forms_stride() const { return (2 * forms + 15) / 8 * 8; }
};

/// Sums over the nodes of a tile, or of all.
struct NodalSums {
  Position S = Position::Zero();       ///< first moment [kg m]
  Position S_rate = Position::Zero();  ///< [kg m/s]
  Matrix3 J = Matrix3::Zero();         ///< sum r mu^T [kg m^2]
  Matrix3 G = Matrix3::Zero();         ///< sum r mu'^T [kg m^2/s]
  double rate_energy = 0.0;            ///< 1/2 sum r'.mu' [J]
  double dissipation = 0.0;            ///< q'^T D q' [W]
};

/// Values of a node's motion: r, 0, r', 0.
inline constexpr int kNodeMotion = 8;

/// Memory of the terms.
struct NodalWork {
  /// Four a row: C_w^T and Q_f of all coordinates, then the shares. Null: only sums are wanted.
  double* rows = nullptr;
  double* motions = nullptr;  ///< by node of each tile kNodeMotion
  NodalSums* sums = nullptr;  ///< by tile
  /// By tile: forms q^T K_k q, then q'^T K_k q; then those of all.
  double* forms = nullptr;
};

/// Makes the tiles of a nodal solid. `forms`: scalar geometric stiffness matrices, as values in the
/// places of those of m; as many as a multiple of three.
NodalTiles make_nodal_tiles(const SolidConstants& solid, const std::vector<Eigen::VectorXd>& forms);

}  // namespace spoke::space
