// Goes once through the nodes of a tile and once through the rows of K.

#include "engine/bodies/space/nodal_terms.h"

#include <algorithm>
#include <cassert>
#include <memory>

#include "models/support/simd.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

constexpr int kRow = 4;  ///< values of a row

[[gnu::always_inline]] inline double* at(double* values, int width, int index) {
  return values + static_cast<std::ptrdiff_t>(width) * index;
}
[[gnu::always_inline]] inline double dot3(const Double4& a, const Double4& b) {
  const Double4 product = a * b;
  return (product[0] + product[1]) + product[2];
}

/// The rows that a tile adds to: those of its slice, and its share of those between slices.
struct TileRows {
  double* rows;
  double* share;  ///< as if it held all coordinates
  int between;

  TileRows(const NodalTiles& tiles, const NodalTile& tile, double* all)
      : rows(all),
        share(all ? at(all, kRow, tiles.coordinates + tile.share - tile.first_between) : nullptr),
        between(tiles.between) {}
  [[gnu::always_inline]] double* row(int coordinate) const {
    return at(coordinate < between ? rows : share, kRow, coordinate);
  }
};

void clear_rows(const NodalTiles& tiles, const NodalTile& tile, double* rows) {
  std::fill(at(rows, kRow, tile.first), at(rows, kRow, tile.end), 0.0);
  std::fill_n(at(rows, kRow, tiles.coordinates + tile.share),
              kRow * (tile.end_between - tile.first_between), 0.0);
}

/// Calculates r and r' of the nodes.
void gather_motions(const NodalTile& tile, const double* q, const double* v, double* motions) {
  const double* place = tile.places.data();
  for (std::size_t i = 0; i < tile.nodes.size(); ++i, place += 4, motions += kNodeMotion) {
    Double4 r = load4(place), rate{};
    for (int c = tile.first_column[i]; c < tile.first_column[i + 1]; ++c) {
      const NodeColumn& column = tile.columns[static_cast<std::size_t>(c)];
      const Double4 u{column.column[0], column.column[1], column.column[2], 0.0};
      r += q[column.coordinate] * u;
      rate += v[column.coordinate] * u;
    }
    store(r, motions);
    store(rate, motions + 4);
  }
}

/// Sums in registers.
struct RunningSums {
  Double4 S{}, S_rate{}, J[3]{}, G[3]{}, energy{};

  [[gnu::always_inline]] void add(const Double4& r, const Double4& rate, const Double4& mu,
                                  const Double4& mu_rate) {
    energy += rate * mu_rate;
    S += mu;
    S_rate += mu_rate;
    for (int a = 0; a < 3; ++a) {
      J[a] += r[a] * mu;
      G[a] += r[a] * mu_rate;
    }
  }
  void store_to(NodalSums& sums) const {
    sums.rate_energy = 0.5 * ((energy[0] + energy[1]) + energy[2]);
    for (int b = 0; b < 3; ++b) {
      sums.S[b] = S[b];
      sums.S_rate[b] = S_rate[b];
      for (int a = 0; a < 3; ++a) {
        sums.J(a, b) = J[a][b];
        sums.G(a, b) = G[a][b];
      }
    }
  }
};

/// The inertia force of a node at zero X and q''.
struct NodeInertia {
  double w[3], ww;

  explicit NodeInertia(const Angular& w0) : w{w0[0], w0[1], w0[2]}, ww(w0.squaredNorm()) {}
  [[gnu::always_inline]] Double4 force(const Double4& mu, const Double4& rate) const {
    const double along = w[0] * mu[0] + w[1] * mu[1] + w[2] * mu[2];
    return Double4{ww * mu[0] - along * w[0] - 2.0 * (w[1] * rate[2] - w[2] * rate[1]),
                   ww * mu[1] - along * w[1] - 2.0 * (w[2] * rate[0] - w[0] * rate[2]),
                   ww * mu[2] - along * w[2] - 2.0 * (w[0] * rate[1] - w[1] * rate[0]), 0.0};
  }
};

/// Returns sum_k weight_k kg_k u of own node i, for three of the matrices from `k` on, and adds
/// their forms.
[[gnu::always_inline]] inline Double4 multiply_forms(const NodalTiles& tiles, const NodalTile& tile,
                                                     std::size_t i, int k, const double* weights,
                                                     const double* motions, double* forms) {
  Double4 sums[3]{};
  const double* kg =
      tile.forms.data() + static_cast<std::ptrdiff_t>(tiles.forms) * tile.first_mass[i] + k;
  for (int e = tile.first_mass[i]; e < tile.first_mass[i + 1]; ++e, kg += tiles.forms) {
    const int j = tile.mass_nodes[static_cast<std::size_t>(e)];
    const Double4 u = load4(motions + kNodeMotion * j) - load4(tile.places.data() + 4 * j);
    for (int c = 0; c < 3; ++c) sums[c] += kg[c] * u;
  }
  const double* own = motions + kNodeMotion * i;
  const Double4 u = load4(own) - load4(tile.places.data() + 4 * i), rate = load4(own + 4);
  for (int c = 0; c < 3; ++c) {
    forms[k + c] += dot3(u, sums[c]);
    forms[tiles.forms + k + c] += dot3(rate, sums[c]);
  }
  return weights[k] * sums[0] + weights[k + 1] * sums[1] + weights[k + 2] * sums[2];
}

/// Adds the rows Xi^T [e_a x mu, b] of a node.
[[gnu::always_inline]] inline void add_rows(const NodalTile& tile, std::size_t i, const Double4& mu,
                                            const Double4& b, const TileRows& rows) {
  const Double4 x{0.0, mu[2], -mu[1], b[0]}, y{-mu[2], 0.0, mu[0], b[1]},
      z{mu[1], -mu[0], 0.0, b[2]};
  for (int c = tile.first_column[i]; c < tile.first_column[i + 1]; ++c) {
    const NodeColumn& column = tile.columns[static_cast<std::size_t>(c)];
    double* const row = rows.row(column.coordinate);
    store(load4(row) + (column.column[0] * x + column.column[1] * y + column.column[2] * z), row);
  }
}

void add_inertia(const NodalTiles& tiles, const NodalTile& tile, const Angular& w,
                 const double* weights, const double* motions, double* forms, const TileRows& rows,
                 NodalSums& sums) {
  const NodeInertia inertia(w);
  RunningSums running;
  for (std::size_t i = 0; i < static_cast<std::size_t>(tile.own); ++i) {
    Double4 mu{}, mu_rate{};
    for (int e = tile.first_mass[i]; e < tile.first_mass[i + 1]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      const double* node = motions + kNodeMotion * tile.mass_nodes[entry];
      mu += tile.m[entry] * load4(node);
      mu_rate += tile.m[entry] * load4(node + 4);
    }
    running.add(load4(motions + kNodeMotion * i), load4(motions + kNodeMotion * i + 4), mu,
                mu_rate);
    Double4 b = inertia.force(mu, mu_rate);
    for (int k = 0; k < tiles.forms; k += 3)
      b -= multiply_forms(tiles, tile, i, k, weights, motions, forms);
    if (rows.rows) add_rows(tile, i, mu, b, rows);
  }
  running.store_to(sums);
}

/// Returns the product of four rows with x.
[[gnu::always_inline]] inline Double4 multiply_rows(const NodalTile& tile,
                                                    const StiffnessRows& rows,
                                                    const std::vector<double>& values,
                                                    const double* x) {
  Double4 even{}, odd{};
  const double* value = values.data() + 4 * rows.begin;
  const int *column = tile.K_columns.data() + rows.begin, *end = tile.K_columns.data() + rows.end;
  for (; column + 1 < end; column += 2, value += 8) {
    even += x[column[0]] * load4(value);
    odd += x[column[1]] * load4(value + 4);
  }
  if (column < end) even += x[column[0]] * load4(value);
  return even + odd;
}

void subtract_elastic_force(const NodalTile& tile, const double* q, const TileRows& all) {
  for (const StiffnessRows& rows : tile.K_rows) {
    const Double4 force = multiply_rows(tile, rows, tile.K, q);
    double* const row = all.row(rows.first) + 3;
    for (int i = 0; i < rows.count; ++i) row[kRow * i] -= force[i];
  }
}

/// Takes off the damping force at v_elastic; returns its power at v.
double subtract_damping(const NodalTile& tile, const Damping& damping, const double* v_elastic,
                        const double* v, const TileRows& all) {
  const double a = damping.mass_factor, b = damping.stiffness_factor;
  const auto multiply = [&](const StiffnessRows& rows, const double* x) {
    Double4 sum{};
    if (b != 0.0) sum += b * multiply_rows(tile, rows, tile.K, x);
    if (a != 0.0) sum += a * multiply_rows(tile, rows, tile.Mff, x);
    return sum;
  };
  double power = 0.0;
  for (const StiffnessRows& rows : tile.K_rows) {
    const Double4 of_v = multiply(rows, v);
    const Double4 force = v_elastic == v ? of_v : multiply(rows, v_elastic);
    double* const row = all.row(rows.first) + 3;
    for (int i = 0; i < rows.count; ++i) {
      row[kRow * i] -= force[i];
      power += v[rows.first + i] * of_v[i];
    }
  }
  return power;
}

void calc_tile(const NodalTiles& tiles, int p, const BodyState& state, const Angular& w,
               const Damping& damping, const double* weights, const NodalWork& work) {
  const NodalTile& tile = tiles.tiles[static_cast<std::size_t>(p)];
  double* const motions = work.motions + tile.first_motion;
  double* const forms = at(work.forms, tiles.forms_stride(), p);
  std::fill_n(forms, 2 * tiles.forms, 0.0);
  if (work.rows) clear_rows(tiles, tile, work.rows);
  const TileRows rows(tiles, tile, work.rows);
  NodalSums& sums = work.sums[p];
  gather_motions(tile, state.q, state.v, motions);
  add_inertia(tiles, tile, w, weights, motions, forms, rows, sums);
  sums.dissipation = 0.0;
  if (!work.rows) return;
  subtract_elastic_force(tile, state.q_elastic, rows);
  if (damping.mass_factor != 0.0 || damping.stiffness_factor != 0.0)
    sums.dissipation = subtract_damping(tile, damping, state.v_elastic, state.v, rows);
}

}  // namespace

std::size_t count_nodal_work(const NodalTiles& tiles) {
  const auto count = static_cast<std::size_t>(tiles.count());
  const auto nodes = static_cast<std::size_t>(tiles.nodes);
  const auto forms = static_cast<std::size_t>(tiles.forms_stride());
  return kNodeMotion * nodes + count * sizeof(NodalSums) / sizeof(double) + forms * (count + 1);
}

NodalWork place_nodal_work(const NodalTiles& tiles, double* rows, double* memory) {
  static_assert(sizeof(NodalSums) % sizeof(double) == 0 && alignof(NodalSums) <= alignof(double));
  const auto count = static_cast<std::size_t>(tiles.count());
  NodalWork work;
  work.rows = rows;
  work.motions = memory;
  memory += kNodeMotion * static_cast<std::size_t>(tiles.nodes);
  work.sums = reinterpret_cast<NodalSums*>(memory);
  std::uninitialized_default_construct_n(work.sums, count);
  work.forms = memory + count * sizeof(NodalSums) / sizeof(double);
  return work;
}

void calc_tile_terms(const NodalTiles& tiles, int p, const BodyState& state, const Angular& w,
                     const Damping& damping, const double* weights,
                     const NodalWork& work) noexcept {
  assert(p >= 0 && p < tiles.count() && state.q && state.v && state.q_elastic && state.v_elastic);
  assert(weights || tiles.forms == 0);
  run_large_kernel([&]() noexcept { calc_tile(tiles, p, state, w, damping, weights, work); });
}

namespace {

/// Adds the shares of a tile to the rows between slices.
void add_share(const NodalTiles& tiles, const NodalTile& tile, double* rows) {
  const double* share = at(rows, kRow, tiles.coordinates + tile.share);
  double* row = at(rows, kRow, tile.first_between);
  for (int i = tile.first_between; i < tile.end_between; ++i, row += kRow, share += kRow)
    store(load4(row) + load4(share), row);
}

}  // namespace

NodalSums sum_tile_terms(const NodalTiles& tiles, const NodalWork& work) noexcept {
  NodalSums total;
  double* const forms = at(work.forms, tiles.forms_stride(), tiles.count());
  std::fill_n(forms, 2 * tiles.forms, 0.0);
  if (work.rows)
    std::fill(at(work.rows, kRow, tiles.between), at(work.rows, kRow, tiles.coordinates), 0.0);
  for (int p = 0; p < tiles.count(); ++p) {
    const NodalSums& sums = work.sums[p];
    total.S += sums.S;
    total.S_rate += sums.S_rate;
    total.J += sums.J;
    total.G += sums.G;
    total.rate_energy += sums.rate_energy;
    total.dissipation += sums.dissipation;
    const double* own = at(work.forms, tiles.forms_stride(), p);
    for (int k = 0; k < 2 * tiles.forms; ++k) forms[k] += own[k];
    if (work.rows) add_share(tiles, tiles.tiles[static_cast<std::size_t>(p)], work.rows);
  }
  return total;
}

const double* total_forms(const NodalTiles& tiles, const NodalWork& work) {
  return at(work.forms, tiles.forms_stride(), tiles.count());
}

std::vector<std::span<double>> memory_of_tile(const NodalTiles& tiles, int p,
                                              const NodalWork& work) {
  const NodalTile& tile = tiles.tiles[static_cast<std::size_t>(p)];
  const auto forms = static_cast<std::size_t>(2 * tiles.forms);
  std::vector<std::span<double>> memory{
      {work.motions + tile.first_motion, kNodeMotion * tile.nodes.size()},
      {reinterpret_cast<double*>(work.sums + p), sizeof(NodalSums) / sizeof(double)}};
  if (forms > 0) memory.emplace_back(at(work.forms, tiles.forms_stride(), p), forms);
  return memory;
}

std::vector<std::span<double>> rows_of_tile(const NodalTiles& tiles, int p, double* rows) {
  const NodalTile& tile = tiles.tiles[static_cast<std::size_t>(p)];
  std::vector<std::span<double>> memory{{at(rows, kRow, tile.first), at(rows, kRow, tile.end)}};
  if (tile.end_between > tile.first_between) {
    double* const share = at(rows, kRow, tiles.coordinates + tile.share);
    memory.emplace_back(share, at(share, kRow, tile.end_between - tile.first_between));
  }
  return memory;
}

std::span<double> rows_between(const NodalTiles& tiles, double* rows) {
  return {at(rows, kRow, tiles.between), at(rows, kRow, tiles.coordinates)};
}

std::span<double> memory_of_total_forms(const NodalTiles& tiles, const NodalWork& work) {
  return {at(work.forms, tiles.forms_stride(), tiles.count()),
          static_cast<std::size_t>(2 * tiles.forms)};
}

}  // namespace spoke::space
