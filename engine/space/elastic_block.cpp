// Factorises a block-tridiagonal matrix, and keeps the half solutions that never change.

#include "engine/space/elastic_block.h"

#include <Eigen/Dense>

namespace spoke::space {
namespace {

using TwistBlock = Eigen::Matrix<double, kTwist, kTwist, Eigen::RowMajor>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

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

BlockTridiagonal combine(const FlexibleBody& body, const BlockFactors& factors) {
  BlockTridiagonal sum(body.node_count());
  sum.add_scaled(factors.mass, body.M);
  sum.add_scaled(factors.stiffness, body.K);
  sum.add_scaled(factors.damping, body.D);
  return sum;
}

void factorise(const FlexibleBody& body, const BlockTridiagonal& matrix, ElasticBlock& block) {
  const auto size = static_cast<std::size_t>(body.node_count()) * ElasticBlock::kBlock;
  block.inverse.assign(size, 0.0);
  block.below.assign(size, 0.0);
  TwistBlock inverse_before = TwistBlock::Zero();
  for (int k = body.first_node(); k < body.node_count(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    TwistBlock diagonal = matrix.diagonal[at], below = TwistBlock::Zero();
    if (k > body.first_node()) below = matrix.below[at - 1];
    fix_coordinates(body, k, diagonal, below);
    below = (below * inverse_before.transpose()).eval();
    diagonal -= below * below.transpose();
    const TwistBlock L = Eigen::LLT<TwistBlock>(diagonal).matrixL();
    inverse_before = L.triangularView<Eigen::Lower>().solve(TwistBlock::Identity());
    Eigen::Map<TwistBlock>(&block.inverse[at * ElasticBlock::kBlock]) = inverse_before;
    Eigen::Map<TwistBlock>(&block.below[at * ElasticBlock::kBlock]) = below;
  }
}

/// L^-1 b, for columns over all nodes. Rows of fixed coordinates are zero.
Columns solve_half(const FlexibleBody& body, const ElasticBlock& block, Columns b) {
  for (int k = 0; k < body.node_count(); ++k)
    for (int c = 0; c < kTwist; ++c)
      if (body.coordinate(k, c) < 0) b.row(kTwist * k + c).setZero();
  for (int k = body.first_node(); k < body.node_count(); ++k) {
    auto rows = b.middleRows<kTwist>(kTwist * k);
    if (k > body.first_node())
      rows -=
          Eigen::Map<const TwistBlock>(block.below_of(k)) * b.middleRows<kTwist>(kTwist * (k - 1));
    rows = (Eigen::Map<const TwistBlock>(block.inverse_of(k)) * rows).eval();
  }
  return b;
}

Columns momentum_columns(const FlexibleBody& body) {
  Columns C_t(kTwist * body.node_count(), 3);
  for (int k = 0; k < body.node_count(); ++k)
    C_t.middleRows<kTwist>(kTwist * k) = body.C_t[static_cast<std::size_t>(k)];
  return C_t;
}

Columns handle_columns(const FlexibleBody& body, int node) {
  Columns E = Columns::Zero(kTwist * body.node_count(), kTwist);
  E.middleRows<kTwist>(kTwist * node).setIdentity();
  return E;
}

}  // namespace

ElasticBlock make_elastic_block(const FlexibleBody& body, const BlockFactors& factors) {
  ElasticBlock block;
  factorise(body, combine(body, factors), block);
  const Columns W_t = solve_half(body, block, momentum_columns(body));
  block.W_t.assign(W_t.data(), W_t.data() + W_t.size());
  block.C_W = W_t.transpose() * W_t;
  std::vector<Columns> Z;
  for (const int node : body.handles) {
    Z.push_back(solve_half(body, block, handle_columns(body, node)));
    const Columns& z = Z.back();
    const double* first = z.data() + Eigen::Index{kTwist} * kTwist * node;
    block.Z.push_back(z.isZero(0.0) ? std::vector<double>{}
                                    : std::vector<double>(first, z.data() + z.size()));
    block.Z_W.push_back(Z.back().transpose() * W_t);
  }
  for (std::size_t b = 0; b < Z.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) block.Z_pairs.push_back(Z[a].transpose() * Z[b]);
    block.Z_diagonal.push_back(SymmetricTwistMatrix::from_matrix(Z[b].transpose() * Z[b]));
  }
  return block;
}

}  // namespace spoke::space
