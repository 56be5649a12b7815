#pragma once

// Symmetric matrices over the nodes of a chain of elements, six rows a node.

#include <Eigen/Core>
#include <cassert>
#include <vector>

#include "models/space/vectors.h"

namespace spoke::space {

struct BlockTridiagonal {
  std::vector<TwistMatrix> diagonal;  ///< diagonal block of each node
  std::vector<TwistMatrix> below;     ///< block (k + 1, k)

  BlockTridiagonal() = default;
  explicit BlockTridiagonal(int nodes)
      : diagonal(static_cast<std::size_t>(nodes), TwistMatrix::Zero()),
        below(static_cast<std::size_t>(nodes - 1), TwistMatrix::Zero()) {}

  int nodes() const { return static_cast<int>(diagonal.size()); }

  /// Adds the symmetric matrix of the element between nodes e and e + 1.
  void add(int e, const Eigen::Matrix<double, 2 * kTwist, 2 * kTwist>& matrix) {
    assert(e >= 0 && e + 1 < nodes());
    const auto k = static_cast<std::size_t>(e);
    diagonal[k] += matrix.topLeftCorner<kTwist, kTwist>();
    diagonal[k + 1] += matrix.bottomRightCorner<kTwist, kTwist>();
    below[k] += matrix.bottomLeftCorner<kTwist, kTwist>();
  }
  /// this += factor * other.
  void add_scaled(double factor, const BlockTridiagonal& other) {
    assert(other.nodes() == nodes() && other.below.size() == below.size());
    for (std::size_t k = 0; k < diagonal.size(); ++k) diagonal[k] += factor * other.diagonal[k];
    for (std::size_t k = 0; k < below.size(); ++k) below[k] += factor * other.below[k];
  }
};

}  // namespace spoke::space
