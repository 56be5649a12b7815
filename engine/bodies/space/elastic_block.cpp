// Factorises a block-tridiagonal matrix, and keeps half solutions.

#include "engine/bodies/space/elastic_block.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

using TwistBlock = Eigen::Matrix<double, kTwist, kTwist, Eigen::RowMajor>;

/// Replaces rows and columns of fixed coordinates by those of the identity.
void fix_coordinates(const FlexibleBody& body, int node, TwistBlock& diagonal, TwistBlock& below) {
  for (int c = 0; c < kTwist; ++c) {
    if (body.coordinate(node, c) < 0) {
      diagonal.row(c).setZero();
      diagonal.col(c).setZero();
      diagonal(c, c) = 1.0;
      below.row(c).setZero();
    }
    if (node > 0 && body.coordinate(node - 1, c) < 0) below.col(c).setZero();
  }
}

/// Values that stand row by row, `kColumns` a row, at one node.
template <int kColumns>
using NodeRows = Eigen::Matrix<double, kTwist, kColumns, Eigen::RowMajor>;
template <int kColumns>
using NodeMap = Eigen::Map<NodeRows<kColumns>>;

/// Sets the inverse of the Cholesky factor of a block. Returns whether the block is positive
/// definite; one that is no number, of a simulation that diverges, passes.
bool invert_factor(const TwistBlock& block, TwistBlock& inverse) {
  const Eigen::LLT<TwistBlock> cholesky(block);
  if (cholesky.info() != Eigen::Success) return false;
  const TwistBlock L = cholesky.matrixL();
  inverse = L.triangularView<Eigen::Lower>().solve(TwistBlock::Identity());
  return true;
}

/// The same for bodies whose factor changes each step: elimination of `block` below a column
/// eliminates the identity, too, and each pivot scales its row of it.
[[gnu::always_inline]] inline bool invert_factor_quickly(TwistBlock block, TwistBlock& inverse) {
  inverse.setIdentity();
  for (int k = 0; k < kTwist; ++k) {
    if (block(k, k) <= 0.0) return false;
    const double by_pivot = 1.0 / block(k, k), scale = std::sqrt(by_pivot);
    for (int i = k + 1; i < kTwist; ++i) {
      const double factor = block(i, k) * by_pivot;
      for (int j = k + 1; j < kTwist; ++j) block(i, j) -= factor * block(k, j);
      for (int j = 0; j <= k; ++j) inverse(i, j) -= factor * inverse(k, j);
    }
    for (int j = 0; j <= k; ++j) inverse(k, j) *= scale;
  }
  return true;
}

/// Sets the factors of Mhat + `added`, which may be null. Returns whether it is positive definite.
[[gnu::always_inline]] inline bool factorise(const FlexibleBody& body, const BlockFactors& factors,
                                             const BlockTridiagonal* added, ElasticBlock& block) {
  TwistBlock inverse_before = TwistBlock::Zero();
  const auto sum = [&](std::vector<TwistMatrix> BlockTridiagonal::*part, std::size_t at) {
    TwistBlock total = factors.mass * (body.M.*part)[at];
    total += factors.stiffness * (body.K.*part)[at];
    total += factors.damping * (body.D.*part)[at];
    if (added) total += (added->*part)[at];
    return total;
  };
  for (int k = body.first_node(); k < body.node_count(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    TwistBlock diagonal = sum(&BlockTridiagonal::diagonal, at), below = TwistBlock::Zero();
    if (k > body.first_node()) below = sum(&BlockTridiagonal::below, at - 1);
    fix_coordinates(body, k, diagonal, below);
    below = below.lazyProduct(inverse_before.transpose()).eval();
    diagonal -= below.lazyProduct(below.transpose());
    const bool is_definite = body.is_nonlinear() ? invert_factor_quickly(diagonal, inverse_before)
                                                 : invert_factor(diagonal, inverse_before);
    if (!is_definite) return false;
    Eigen::Map<TwistBlock>(&block.inverse[at * ElasticBlock::kBlock]) = inverse_before;
    Eigen::Map<TwistBlock>(&block.below[at * ElasticBlock::kBlock]) = below;
  }
  return true;
}

/// Solves L y = b in place, for columns that are zero before node `from`, whose rows stand at b.
/// Rows of fixed coordinates are zero.
template <int kColumns>
void solve_half(const FlexibleBody& body, const ElasticBlock& block, int from, double* b) {
  assert(from >= 0 && from < body.node_count());
  for (int k = from; k < body.node_count(); ++k, b += kTwist * kColumns) {
    NodeMap<kColumns> rows(b);
    for (int c = 0; c < kTwist; ++c)
      if (body.coordinate(k, c) < 0) rows.row(c).setZero();
    if (k < body.first_node()) continue;
    if (k > from)
      rows -= Eigen::Map<const TwistBlock>(block.below_of(k))
                  .lazyProduct(NodeMap<kColumns>(b - kTwist * kColumns));
    rows = Eigen::Map<const TwistBlock>(block.inverse_of(k)).lazyProduct(rows).eval();
  }
}

/// Returns a^T b of columns over the nodes from `from` on, where both begin.
template <int kA, int kB>
Eigen::Matrix<double, kA, kB> multiply_columns(const FlexibleBody& body, int from, const double* a,
                                               const double* b) {
  Eigen::Matrix<double, kA, kB> sum = Eigen::Matrix<double, kA, kB>::Zero();
  for (int k = from; k < body.node_count(); ++k, a += kTwist * kA, b += kTwist * kB)
    sum += Eigen::Map<const NodeRows<kA>>(a).transpose().lazyProduct(
        Eigen::Map<const NodeRows<kB>>(b));
  return sum;
}

bool is_fixed(const FlexibleBody& body, int node) {
  for (int c = 0; c < kTwist; ++c)
    if (body.coordinate(node, c) >= 0) return false;
  return true;
}

/// Allocates the factors and solutions.
ElasticBlock make_empty_block(const FlexibleBody& body) {
  const auto nodes = static_cast<std::size_t>(body.node_count());
  ElasticBlock block;
  block.inverse.assign(nodes * ElasticBlock::kBlock, 0.0);
  block.below.assign(nodes * ElasticBlock::kBlock, 0.0);
  block.W_t.assign(nodes * 3 * kTwist, 0.0);
  const std::size_t handles = body.handles.size();
  for (std::size_t h = 0; h < handles; ++h)
    block.Z.emplace_back(is_fixed(body, body.handles[h])
                             ? 0
                             : (nodes - static_cast<std::size_t>(first_of_handle(body, h))) *
                                   ElasticBlock::kBlock);
  block.Z_W.assign(handles, NodeMomentum::Zero());
  block.Z_diagonal.assign(handles, SymmetricTwistMatrix::from_matrix(TwistMatrix::Zero()));
  block.Z_pairs.assign(handles * (handles - 1) / 2, TwistMatrix::Zero());
  return block;
}

// Columns of a block over the nodes from `from` on.

double* W_t_from(ElasticBlock& block, int from) { return block.W_t.data() + 3 * kTwist * from; }
const double* Z_from(const FlexibleBody& body, const ElasticBlock& block, std::size_t h, int from) {
  return block.Z[h].data() + ElasticBlock::kBlock * (from - first_of_handle(body, h));
}

void set_momentum(const FlexibleBody& body, const ImplicitShift* shift, ElasticBlock& block) {
  for (int k = 0; k < body.node_count(); ++k)
    NodeMap<3>(W_t_from(block, k)) = body.C_t[static_cast<std::size_t>(k)];
  double* const W_t = W_t_from(block, 0);
  if (shift) shift->apply_transposed<3>(W_t);
  solve_half<3>(body, block, 0, W_t);
  block.C_W = multiply_columns<3, 3>(body, 0, W_t, W_t);
}

/// Sets the solutions of handle h alone; they stay zero where the frame fixes the handle's node.
void set_handle(const FlexibleBody& body, std::size_t h, const ImplicitShift* shift,
                ElasticBlock& block) {
  std::vector<double>& Z = block.Z[h];
  if (Z.empty()) return;
  const int node = body.handles[h], first = first_of_handle(body, h);
  std::fill(Z.begin(), Z.end(), 0.0);
  NodeMap<kTwist>(Z.data() + ElasticBlock::kBlock * (node - first)).setIdentity();
  if (shift && node > 0 && node < body.elements)
    shift->apply_transposed<kTwist>(node, first, Z.data());
  solve_half<kTwist>(body, block, first, Z.data());
  block.Z_W[h] = multiply_columns<kTwist, 3>(body, first, Z.data(), W_t_from(block, first));
  block.Z_diagonal[h] = SymmetricTwistMatrix::from_matrix(
      multiply_columns<kTwist, kTwist>(body, first, Z.data(), Z.data()));
}

void set_pair(const FlexibleBody& body, std::size_t a, std::size_t b, ElasticBlock& block) {
  if (block.Z[a].empty() || block.Z[b].empty()) return;
  const int from = std::max(first_of_handle(body, a), first_of_handle(body, b));
  const auto pair = static_cast<std::size_t>(
      tree::MultiPort<Space>::count_pairs(static_cast<int>(b)) + static_cast<int>(a));
  block.Z_pairs[pair] = multiply_columns<kTwist, kTwist>(body, from, Z_from(body, block, a, from),
                                                         Z_from(body, block, b, from));
}

[[gnu::always_inline]] inline bool set_block(const FlexibleBody& body, const BlockFactors& factors,
                                             const BlockTridiagonal* added,
                                             const ImplicitShift* shift, ElasticBlock& block) {
  assert(std::cmp_equal(body.M.nodes(), body.node_count()) && body.K.nodes() == body.M.nodes());
  assert(!added || added->nodes() == body.node_count());
  assert(block.Z.size() == body.handles.size() && block.below.size() == block.inverse.size());
  if (!factorise(body, factors, added, block)) return false;
  set_momentum(body, shift, block);
  for (std::size_t b = 0; b < body.handles.size(); ++b) {
    set_handle(body, b, shift, block);
    for (std::size_t a = 0; a < b; ++a) set_pair(body, a, b, block);
  }
  return true;
}

}  // namespace

int first_of_handle(const FlexibleBody& body, std::size_t handle) {
  const int node = body.handles[handle];
  const bool is_shifted = body.is_nonlinear() && node < body.elements;
  return is_shifted ? std::max(node - 1, std::min(node, body.first_node())) : node;
}

ElasticBlock make_elastic_block(const FlexibleBody& body, const BlockFactors& factors) {
  ElasticBlock block = make_empty_block(body);
  [[maybe_unused]] const bool is_set = set_block(body, factors, nullptr, nullptr, block);
  assert(is_set && "positive definite");
  return block;
}

bool factorise_anew(const FlexibleBody& body, const BlockFactors& factors,
                    const BlockTridiagonal& added, const ImplicitShift* shift,
                    ElasticBlock& block) noexcept {
  if (!shift) return set_block(body, factors, &added, nullptr, block);
  return run_large_kernel([&] { return set_block(body, factors, &added, shift, block); });
}

}  // namespace spoke::space
