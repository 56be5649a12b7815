// Factorises the block of a solid, and keeps half solutions.

#include "engine/bodies/space/solid_block.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "engine/bodies/space/sparse_solve.h"
#include "models/space/nodal_mass.h"
#include "models/support/simd.h"

namespace spoke::space {
namespace {

using MomentumMap = Eigen::Matrix<double, kTwist, 3, Eigen::DontAlign>;

/// Returns 1/L of the diagonal block of a reduced solid.
std::vector<double> find_roots(const ReducedSolid& solid, const BlockFactors& factors) {
  std::vector<double> root;
  for (Eigen::Index k = 0; k < solid.stiffness.size(); ++k) {
    const double diagonal =
        factors.mass + factors.stiffness * solid.stiffness[k] + factors.damping * solid.damping[k];
    assert(diagonal > 0.0 && "positive definite");
    root.push_back(1.0 / std::sqrt(diagonal));
  }
  return root;
}

/// Factorises the block of a solid in nodal coordinates. It has the entries of Mff and K, whatever
/// their factors.
SparseFactor factorise_nodal(const NodalSolid& solid, const BlockFactors& factors) {
  NodalSolid::Sparse sum = factors.mass * calc_flexible_mass(solid) + factors.stiffness * solid.K;
  sum.makeCompressed();
  return factorise(sum, solid.slices);
}

std::size_t row_of(int coordinate, int width) {
  return static_cast<std::size_t>(coordinate) * static_cast<std::size_t>(width);
}

void set_momentum(const Eigen::MatrixXd& C_t, SolidBlock& block) {
  const auto n = static_cast<int>(C_t.rows());
  block.y_C.assign(row_of(n, kSolidRow), 0.0);
  for (int k = 0; k < n; ++k)
    for (int c = 0; c < 3; ++c)
      block.y_C[row_of(k, kSolidRow) + static_cast<std::size_t>(c)] = C_t(k, c);
  block.y_C.resize(row_of(count_half_rows(block, n), kSolidRow));
  solve_half(block, n, block.y_C.data(), block.y_C.data());
  block.y_C.resize(row_of(n, kSolidRow));
  block.C_W.setZero();
  for (int k = 0; k < n; ++k) {
    const Eigen::Map<const Eigen::Vector3d> y(&block.y_C[row_of(k, kSolidRow)]);
    block.C_W += y * y.transpose();
  }
}

/// Returns L^-1 E^T of a place, in two passes of four columns.
std::vector<double> solve_place(const SolidBlock& block, int n, const SolidPlace& place) {
  std::vector<double> y(place.is_fixed() ? 0 : row_of(n, kHandleRow), 0.0);
  if (y.empty()) return y;
  std::vector<double> rows(row_of(count_half_rows(block, n), kSolidRow));
  for (int first = 0; first < kTwist; first += kSolidRow) {
    std::fill(rows.begin(), rows.end(), 0.0);
    for (std::size_t i = 0; i < place.at.size(); ++i)
      for (int c = first; c < std::min(kTwist, first + kSolidRow); ++c)
        rows[row_of(place.at[i], kSolidRow) + static_cast<std::size_t>(c - first)] =
            place.columns[i][c];
    solve_half(block, n, rows.data(), rows.data());
    for (int k = 0; k < n; ++k)
      store(load4(&rows[row_of(k, kSolidRow)]),
            &y[row_of(k, kHandleRow) + static_cast<std::size_t>(first)]);
  }
  return y;
}

TwistMatrix multiply_places(const std::vector<double>& a, const std::vector<double>& b) {
  TwistMatrix sum = TwistMatrix::Zero();
  for (std::size_t k = 0; k < a.size(); k += kHandleRow)
    sum += Eigen::Map<const Twist>(&a[k]) * Eigen::Map<const Twist>(&b[k]).transpose();
  return sum;
}

MomentumMap multiply_momentum(const std::vector<double>& y_E, const SolidBlock& block) {
  MomentumMap sum = MomentumMap::Zero();
  for (std::size_t k = 0; kHandleRow * k < y_E.size(); ++k)
    sum += Eigen::Map<const Twist>(&y_E[kHandleRow * k]) *
           Eigen::Map<const Eigen::Vector3d>(&block.y_C[kSolidRow * k]).transpose();
  return sum;
}

void add_handle(const Solid& body, std::size_t h, SolidBlock& block) {
  block.y_E.push_back(solve_place(block, body.coordinates(), body.handle(h)));
  const std::vector<double>& y = block.y_E.back();
  block.E_W.push_back(multiply_momentum(y, block));
  block.Z_diagonal.push_back(SymmetricTwistMatrix::from_matrix(multiply_places(y, y)));
  for (std::size_t a = 0; a < h; ++a)
    block.Z_pairs.push_back(block.y_E[a].empty() || y.empty() ? TwistMatrix(TwistMatrix::Zero())
                                                              : multiply_places(block.y_E[a], y));
}

}  // namespace

SolidBlock make_solid_block(const Solid& body, const BlockFactors& factors) {
  const SolidConstants& constants = *body.constants;
  SolidBlock block;
  if (const ReducedSolid* reduced = constants.reduced())
    block.root = find_roots(*reduced, factors);
  else
    block.factor = factorise_nodal(*constants.nodal(), factors);
  set_momentum(constants.C_t(), block);
  for (std::size_t h = 0; h < body.handles.size(); ++h) add_handle(body, h, block);
  return block;
}

int count_half_rows(const SolidBlock& block, int coordinates) {
  return block.factor ? block.factor->half_rows() : coordinates;
}

void solve_half(const SolidBlock& block, int coordinates, const double* b, double* y) noexcept {
  if (block.factor) return solve_half(*block.factor, b, y);
  assert(std::cmp_equal(block.root.size(), coordinates));
  for (int k = 0; k < coordinates; ++k)
    store(block.root[static_cast<std::size_t>(k)] * load4(b + kSolidRow * k), y + kSolidRow * k);
}

void solve_back(const SolidBlock& block, int coordinates, double* x) noexcept {
  if (block.factor) return solve_back(*block.factor, x);
  assert(std::cmp_equal(block.root.size(), coordinates));
  for (int k = 0; k < coordinates; ++k) x[k] *= block.root[static_cast<std::size_t>(k)];
}

}  // namespace spoke::space
