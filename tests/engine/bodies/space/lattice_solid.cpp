#include "tests/engine/bodies/space/lattice_solid.h"

#include "models/space/rotation.h"

namespace spoke::test {
namespace {

using space::Matrix3;
using space::Position;
using Triplets = std::vector<Eigen::Triplet<double>>;

struct Grid {
  explicit Grid(const Lattice& lattice) : l(lattice) {}
  int node(int i, int j, int k) const { return (i * (l.y + 1) + j) * (l.z + 1) + k; }
  int count() const { return (l.x + 1) * (l.y + 1) * (l.z + 1); }
  int plane() const { return (l.y + 1) * (l.z + 1); }
  Position place(int node) const {
    const int k = node % (l.z + 1), j = node / (l.z + 1) % (l.y + 1);
    return l.cell * Position(node / plane(), j - 0.5 * l.y, k - 0.5 * l.z);
  }
  template <class Visit>
  void for_cells(Visit&& visit) const {
    for (int i = 0; i < l.x; ++i)
      for (int j = 0; j < l.y; ++j)
        for (int k = 0; k < l.z; ++k) {
          std::array<int, 8> corners{};
          for (int c = 0; c < 8; ++c)
            corners[static_cast<std::size_t>(c)] = node(i + c % 2, j + c / 2 % 2, k + c / 4);
          visit(corners);
        }
  }

  const Lattice& l;
};

Eigen::SparseMatrix<double> gather(int rows, int columns, const Triplets& entries) {
  Eigen::SparseMatrix<double> matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::SparseMatrix<double> make_mass(const Grid& grid) {
  Triplets entries;
  const double mass = 2700.0 * grid.l.cell * grid.l.cell * grid.l.cell / 72.0;
  grid.for_cells([&](const std::array<int, 8>& corners) {
    for (const int a : corners)
      for (const int b : corners) entries.emplace_back(a, b, a == b ? 2.0 * mass : mass);
  });
  return gather(grid.count(), grid.count(), entries);
}

Eigen::SparseMatrix<double> make_stiffness(const Grid& grid) {
  Triplets entries;
  const auto add = [&entries](int a, int b, const Matrix3& k) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) entries.emplace_back(3 * a + i, 3 * b + j, k(i, j));
  };
  grid.for_cells([&](const std::array<int, 8>& corners) {
    for (const int a : corners)
      for (const int b : corners) {
        if (a >= b) continue;
        const Position d = (grid.place(b) - grid.place(a)) / grid.l.cell;
        const Matrix3 k = 1e6 * d * d.transpose() / d.squaredNorm();
        add(a, a, k);
        add(b, b, k);
        add(a, b, -k);
        add(b, a, -k);
      }
  });
  return gather(3 * grid.count(), 3 * grid.count(), entries);
}

}  // namespace

space::SolidConstants make_lattice(const Lattice& lattice) {
  const Grid grid(lattice);
  const int n = grid.count(), plane = grid.plane();
  space::SolidConstants solid;
  space::NodalSolid nodal;
  for (int i = 0; i < n; ++i) solid.nodes.push_back(grid.place(i));
  nodal.m = make_mass(grid);
  Triplets Xi;
  int free = lattice.has_rigid_end ? 6 : 0;
  const Position p(lattice.cell * lattice.x, 0.0, 0.0);
  for (int i = plane; i < n; ++i) {
    const bool is_rigid = lattice.has_rigid_end && i >= n - plane;
    for (int c = 0; c < 3; ++c) Xi.emplace_back(3 * i + c, is_rigid ? c : free++, 1.0);
    if (!is_rigid) continue;
    const Matrix3 turn = -space::skew(Position(grid.place(i) - p));
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        if (turn(a, b) != 0.0) Xi.emplace_back(3 * i + a, 3 + b, turn(a, b));
  }
  nodal.Xi = gather(3 * n, free, Xi);
  nodal.K = Eigen::SparseMatrix<double>(nodal.Xi.transpose()) *
            Eigen::SparseMatrix<double>(make_stiffness(grid) * nodal.Xi);
  solid.coordinates = free;
  solid.extent = p.x();
  const Eigen::VectorXd me = nodal.m * Eigen::VectorXd::Ones(n);
  solid.mass = me.sum();
  Eigen::MatrixXd x(n, 3);
  for (int i = 0; i < n; ++i) x.row(i) = grid.place(i).transpose();
  solid.S0 = x.transpose() * me;
  solid.J0 = x.transpose() * (nodal.m * x);
  space::SolidPlace root, tip;
  root.name = "root";
  tip.name = "tip";
  tip.p = p;
  if (lattice.has_rigid_end) {
    for (int c = 0; c < 6; ++c) {
      tip.at.push_back(c);
      tip.columns.push_back(space::Twist::Unit(c));
    }
  } else {
    for (int i = 0; i < 3 * plane; ++i) {
      tip.at.push_back(free - 3 * plane + i);
      tip.columns.push_back(space::Twist::Unit(i % 3) / plane);
    }
  }
  solid.places = {root, tip};
  solid.matrices = std::move(nodal);
  return solid;
}

}  // namespace spoke::test
