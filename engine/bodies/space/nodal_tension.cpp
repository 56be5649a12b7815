// Sums kg_ij u_i.u_j over the entries of the scalar matrices.

#include "engine/bodies/space/nodal_tension.h"

#include <algorithm>
#include <cassert>

namespace spoke::space {
namespace {

constexpr int kAxes = 3;

/// Calls `visit(mesh node, first column, end)` for the nodes of all tiles.
template <class Visit>
void for_nodes(const NodalTiles& tiles, Visit&& visit) {
  for (const NodalTile& tile : tiles.tiles)
    for (int k = 0; k < tile.own; ++k) {
      const auto i = static_cast<std::size_t>(k);
      visit(tile.nodes[i], tile.columns.data() + tile.first_column[i],
            tile.columns.data() + tile.first_column[i + 1]);
    }
}

/// Sets the displacements x, y, z of all nodes.
void set_displacements(const NodalTiles& tiles, const double* q, double* u) {
  for_nodes(tiles, [&](int node, const NodeColumn* column, const NodeColumn* end) {
    double* const at = u + kAxes * node;
    std::fill_n(at, kAxes, 0.0);
    for (; column != end; ++column)
      for (int c = 0; c < kAxes; ++c) at[c] += q[column->coordinate] * column->column[c];
  });
}

/// Returns sum_j kg_ij u_j.
Position multiply(const NodalSolid& solid, const Eigen::VectorXd& kg, int i, const double* u) {
  Position sum = Position::Zero();
  const int *first = solid.m.outerIndexPtr() + i, *nodes = solid.m.innerIndexPtr();
  for (int e = first[0]; e < first[1]; ++e)
    for (int c = 0; c < kAxes; ++c) sum[c] += kg[e] * u[kAxes * nodes[e] + c];
  return sum;
}

double dot(const double* a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

std::size_t count_nodal_tension(const NodalSolid& solid) {
  return static_cast<std::size_t>(3 * kAxes * solid.m.cols());
}

PlaceDrawn calc_nodal_drawn(const NodalTiles& tiles, const NodalSolid& solid, std::size_t place,
                            const double* q, const double* v, const double* a,
                            double* memory) noexcept {
  assert(place < solid.places.size());
  const auto nodes = static_cast<int>(solid.m.cols());
  double *u = memory, *rate = memory + kAxes * nodes, *second = memory + 2 * kAxes * nodes;
  set_displacements(tiles, q, u);
  set_displacements(tiles, v, rate);
  if (a) set_displacements(tiles, a, second);
  PlaceDrawn drawn;
  for (int c = 0; c < kAxes; ++c) {
    const Eigen::VectorXd& kg = solid.places[place][static_cast<std::size_t>(c)];
    for (int i = 0; i < nodes; ++i) {
      const Position force = multiply(solid, kg, i, u);
      drawn.place[c] -= 0.5 * dot(u + kAxes * i, force);
      drawn.rate[c] -= dot(rate + kAxes * i, force);
      if (!a) continue;
      drawn.acceleration[c] -= dot(rate + kAxes * i, multiply(solid, kg, i, rate));
      drawn.acceleration[c] -= dot(second + kAxes * i, force);
    }
  }
  return drawn;
}

Angular add_nodal_tension(const NodalTiles& tiles, const NodalSolid& solid, std::size_t place,
                          const Position& N, const double* q, const double* v, double* memory,
                          const BodyWork& work, double& power) noexcept {
  assert(place < solid.places.size());
  const auto nodes = static_cast<int>(solid.m.cols());
  double *u = memory, *rate = memory + kAxes * nodes;
  set_displacements(tiles, q, u);
  set_displacements(tiles, v, rate);
  Position drawn = Position::Zero();
  for_nodes(tiles, [&](int node, const NodeColumn* column, const NodeColumn* end) {
    Position sum = Position::Zero();
    for (int c = 0; c < kAxes; ++c) {
      const Position force =
          multiply(solid, solid.places[place][static_cast<std::size_t>(c)], node, u);
      drawn[c] -= 0.5 * dot(u + kAxes * node, force);
      sum += N[c] * force;
    }
    power -= dot(rate + kAxes * node, sum);
    for (; column != end; ++column)
      work.rows[4 * column->coordinate + 3] -= dot(column->column, sum);
  });
  return cross(drawn, N);
}

}  // namespace spoke::space
