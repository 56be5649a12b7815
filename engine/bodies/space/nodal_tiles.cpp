// Gives every node and every row of K to one slice, and renumbers what it reads.

#include "engine/bodies/space/nodal_tiles.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "models/space/nodal_mass.h"

namespace spoke::space {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using ByRow = Eigen::SparseMatrix<double, Eigen::RowMajor>;

std::size_t of(int index) { return static_cast<std::size_t>(index); }

/// Which slice has each node and each coordinate.
struct Owners {
  std::vector<int> first;  ///< of each slice, then of the coordinates between slices
  std::vector<int> nodes, coordinates;

  Owners(const NodalSolid& solid, const ByRow& Xi)
      : first(solid.slices.empty() ? std::vector<int>{0, static_cast<int>(solid.K.cols())}
                                   : solid.slices) {
    find_coordinates(solid.K);
    nodes.assign(of(static_cast<int>(solid.m.cols())), slices());
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
      for (int axis = 0; axis < 3; ++axis)
        for (ByRow::InnerIterator e(Xi, 3 * i + axis); e; ++e) {
          const auto c = static_cast<int>(e.col());
          // A node with a coordinate within a slice is that slice's.
          const int owner = coordinates[of(c)] - (is_between(c) ? 0 : slices());
          nodes[of(i)] = std::min(nodes[of(i)], owner);
        }
    for (int& node : nodes)
      if (node < 0) node += slices();
    find_fixed_nodes(solid.m);
  }

  int slices() const { return static_cast<int>(first.size()) - 1; }
  bool is_between(int coordinate) const { return coordinate >= first.back(); }

 private:
  /// A coordinate between slices is the first slice's that it is coupled with.
  void find_coordinates(const Sparse& K) {
    coordinates.resize(of(static_cast<int>(K.cols())));
    for (int c = 0; c < static_cast<int>(K.cols()); ++c) {
      coordinates[of(c)] =
          static_cast<int>(std::upper_bound(first.begin(), first.end() - 1, c) - first.begin() - 1);
      if (!is_between(c)) continue;
      int owner = slices() - 1;
      for (Sparse::InnerIterator e(K, c); e; ++e)
        if (!is_between(static_cast<int>(e.row())))
          owner = std::min(owner, coordinates[of(static_cast<int>(e.row()))]);
      coordinates[of(c)] = owner;
    }
  }
  /// Nodes that do not move are the slice's of their first neighbour that does.
  void find_fixed_nodes(const Sparse& m) {
    const std::vector<int> moving = nodes;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      if (nodes[of(i)] < slices()) continue;
      for (Sparse::InnerIterator e(m, i); e; ++e)
        nodes[of(i)] = std::min(nodes[of(i)], moving[of(static_cast<int>(e.row()))]);
      if (nodes[of(i)] == slices()) nodes[of(i)] = 0;
    }
  }
};

/// Lists the nodes of a tile: its own, and their neighbours.
std::vector<int> find_nodes(const Sparse& m, const Owners& owners, int p, int& own) {
  std::vector<int> nodes;
  std::vector<bool> is_there(owners.nodes.size(), false);
  for (int i = 0; i < static_cast<int>(owners.nodes.size()); ++i)
    if (owners.nodes[of(i)] == p) {
      nodes.push_back(i);
      is_there[of(i)] = true;
    }
  own = static_cast<int>(nodes.size());
  for (int k = 0; k < own; ++k)
    for (Sparse::InnerIterator e(m, nodes[of(k)]); e; ++e) {
      const auto j = static_cast<int>(e.row());
      if (is_there[of(j)]) continue;
      is_there[of(j)] = true;
      nodes.push_back(j);
    }
  std::sort(nodes.begin() + own, nodes.end());
  return nodes;
}

void set_columns(const SolidConstants& solid, const ByRow& Xi, NodalTile& tile) {
  for (const int node : tile.nodes) {
    const Position& x = solid.nodes[of(node)];
    tile.places.insert(tile.places.end(), {x[0], x[1], x[2], 0.0});
    tile.first_column.push_back(static_cast<int>(tile.columns.size()));
    for (int axis = 0; axis < 3; ++axis)
      for (ByRow::InnerIterator e(Xi, 3 * node + axis); e; ++e) {
        const auto c = static_cast<int>(e.col());
        auto column =
            std::find_if(tile.columns.begin() + tile.first_column.back(), tile.columns.end(),
                         [c](const NodeColumn& other) { return other.coordinate == c; });
        if (column == tile.columns.end()) column = tile.columns.insert(column, NodeColumn{c, {}});
        column->column[axis] += e.value();
      }
  }
  tile.first_column.push_back(static_cast<int>(tile.columns.size()));
}

void set_masses(const Sparse& m, const std::vector<Eigen::VectorXd>& forms, NodalTile& tile) {
  std::vector<int> place(of(static_cast<int>(m.cols())), -1);
  for (std::size_t k = 0; k < tile.nodes.size(); ++k)
    place[of(tile.nodes[k])] = static_cast<int>(k);
  for (int k = 0; k < tile.own; ++k) {
    tile.first_mass.push_back(static_cast<int>(tile.m.size()));
    const int node = tile.nodes[of(k)];
    Eigen::Index entry = m.outerIndexPtr()[node];
    for (Sparse::InnerIterator e(m, node); e; ++e, ++entry) {
      tile.mass_nodes.push_back(place[of(static_cast<int>(e.row()))]);
      tile.m.push_back(e.value());
      for (const Eigen::VectorXd& form : forms) tile.forms.push_back(form[entry]);
    }
  }
  tile.first_mass.push_back(static_cast<int>(tile.m.size()));
}

/// Returns the columns of a row of K or Mff that may hold more than a zero.
std::vector<int> columns_of(const Sparse& K, const Sparse& Mff, int row) {
  std::vector<int> columns;
  for (const Sparse* matrix : {&K, &Mff})
    for (Sparse::InnerIterator e(*matrix, row); e; ++e)
      columns.push_back(static_cast<int>(e.row()));
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

void set_stiffness(const Sparse& K, const Sparse& Mff, const Owners& owners, int p,
                   NodalTile& tile) {
  std::vector<int> columns;
  for (int row = 0; row < static_cast<int>(K.cols()); ++row) {
    if (owners.coordinates[of(row)] != p) continue;
    std::vector<int> own = columns_of(K, Mff, row);
    StiffnessRows* last = tile.K_rows.empty() ? nullptr : &tile.K_rows.back();
    if (!last || last->count == 4 || last->first + last->count != row || own != columns ||
        row == owners.first.back()) {
      columns = std::move(own);
      const std::size_t begin = tile.K_columns.size();
      tile.K_columns.insert(tile.K_columns.end(), columns.begin(), columns.end());
      last = &tile.K_rows.emplace_back(StiffnessRows{row, 0, begin, tile.K_columns.size()});
      tile.K.resize(4 * last->end, 0.0);
      tile.Mff.resize(4 * last->end, 0.0);
    }
    const auto put = [&](const Sparse& matrix, std::vector<double>& values) {
      for (Sparse::InnerIterator e(matrix, row); e; ++e) {
        const auto at = std::lower_bound(columns.begin(), columns.end(), static_cast<int>(e.row()));
        const std::size_t column = last->begin + static_cast<std::size_t>(at - columns.begin());
        values[4 * column + of(last->count)] = e.value();
      }
    };
    put(K, tile.K);
    put(Mff, tile.Mff);
    ++last->count;
  }
}

/// Finds the coordinates between slices that a tile adds to.
void set_share(const Owners& owners, NodalTile& tile, int& shares) {
  int low = static_cast<int>(owners.coordinates.size()), high = owners.first.back();
  const auto add = [&](int coordinate, int count) {
    if (!owners.is_between(coordinate)) return;
    low = std::min(low, coordinate);
    high = std::max(high, coordinate + count);
  };
  for (int c = 0; c < tile.first_column[of(tile.own)]; ++c) add(tile.columns[of(c)].coordinate, 1);
  for (const StiffnessRows& rows : tile.K_rows) add(rows.first, rows.count);
  if (low < high) {
    tile.first_between = low;
    tile.end_between = high;
  }
  tile.share = shares;
  shares += tile.end_between - tile.first_between;
}

}  // namespace

NodalTiles make_nodal_tiles(const SolidConstants& solid,
                            const std::vector<Eigen::VectorXd>& forms) {
  assert(solid.nodal() && forms.size() % 3 == 0);
  const NodalSolid& nodal = *solid.nodal();
  const ByRow Xi = nodal.Xi;
  const Sparse Mff = calc_flexible_mass(nodal);
  const Owners owners(nodal, Xi);
  NodalTiles all;
  all.coordinates = solid.coordinates;
  all.between = owners.first.back();
  all.forms = static_cast<int>(forms.size());
  for (int p = 0; p < owners.slices(); ++p) {
    NodalTile& tile = all.tiles.emplace_back();
    tile.first = owners.first[of(p)];
    tile.end = owners.first[of(p + 1)];
    tile.nodes = find_nodes(nodal.m, owners, p, tile.own);
    set_columns(solid, Xi, tile);
    set_masses(nodal.m, forms, tile);
    set_stiffness(nodal.K, Mff, owners, p, tile);
    set_share(owners, tile, all.shares);
    tile.first_motion = kNodeMotion * all.nodes;
    all.nodes += static_cast<int>(tile.nodes.size());
  }
  return all;
}

}  // namespace spoke::space
